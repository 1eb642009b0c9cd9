// First the comparisons, as rows on the terminal and in out/bench.json; then the benchmarks of bench/, with the options
// of Google Benchmark (--benchmark_filter=...; "none" for the comparisons alone).

#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "paired_ratio.h"

namespace {

void report(const std::vector<murosimf::bench::Row>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    std::printf("%s\n", row.text.c_str());
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
  report(murosimf::bench::kinematicRows());
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
