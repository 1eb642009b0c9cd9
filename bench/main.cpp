// First the comparisons, as rows on the terminal and in out/bench.json; then the benchmarks of bench/, with the options
// of Google Benchmark (--benchmark_filter=...; "none" for the comparisons alone).

#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "paired_ratio.h"

namespace {

using murosimf::bench::Part;
using murosimf::bench::Row;

/// Rows of all parts, printed as they come. @return false when a part has nothing to report
bool collect(const std::vector<Part>& parts, std::vector<Row>& rows) {
  bool complete = true;
  for (const Part& part : parts) {
    try {
      for (Row& row : part()) {
        std::printf("%s\n", row.text.c_str());
        std::fflush(stdout);
        rows.push_back(std::move(row));
      }
    } catch (const std::runtime_error& fault) {
      std::fprintf(stderr, "error: no comparison: %s\n", fault.what());
      complete = false;
    }
  }
  return complete;
}

void write(const std::vector<Row>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    const std::size_t first = row.name.find_first_not_of(' ');
    all.push_back({{"name", row.name.substr(first)},
                   {"ratio", row.ratio},
                   {"ours", row.ours},
                   {"peer", row.peer},
                   {"unit", row.unit},
                   {"isa", row.isa}});
  }
  std::filesystem::create_directories("out");
  std::ofstream("out/bench.json") << all.dump(2) << "\n";
  std::printf("written to out/bench.json\n\n");
}

}  // namespace

int main(int count, char** words) {
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  std::vector<Row> rows;
  bool complete = true;
  for (const auto& parts :
       {murosimf::bench::peerParts(), murosimf::bench::growthParts(), murosimf::bench::fieldParts(),
        murosimf::bench::fullDynamicsParts(), murosimf::bench::passParts(), murosimf::bench::kinematicParts(),
        murosimf::bench::collisionParts(), murosimf::bench::cameraParts(), murosimf::bench::glParts()}) {
    complete = collect(parts, rows) && complete;
  }
  write(rows);
  benchmark::RunSpecifiedBenchmarks();
  return complete ? 0 : 1;
}
