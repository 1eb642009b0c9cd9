// murosimf bench table: the largest number of robots in real time, row by row of the paper's table.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "murosimf/bench/largest_count.h"
#include "murosimf/bench/machine.h"
#include "murosimf/bench/walking_robots.h"
#include "murosimf/commands.h"
#include "murosimf/world/diagnostics.h"

namespace murosimf {

namespace {

/// A row, and the number that the paper gives for one thread of a Core Duo of 1.66 GHz [Friedmann 2007, table 1].
struct TableRow {
  std::string name, level;
  double frame;  // [s]
  Eye eye;
  std::optional<int> paper;
};
const std::vector<TableRow>& allRows() {
  static const std::vector<TableRow> rows{
      {"kinematic", "kinematic", 0.01, Eye::kNone, 10},
      {"simplified", "fast", 0.001, Eye::kNone, 8},
      {"kinematic camera", "kinematic", 0.01, Eye::kStraight, 6},
      {"simplified camera", "fast", 0.001, Eye::kStraight, 5},
      {"kinematic distorted camera", "kinematic", 0.01, Eye::kDistorted, 3},
      {"simplified distorted camera", "fast", 0.001, Eye::kDistorted, 3},
      {"multibody", "full", 0.001, Eye::kNone, std::nullopt},
      {"multibody distorted camera", "full", 0.001, Eye::kDistorted, std::nullopt},
  };
  return rows;
}

/// How long and how closely is measured.
struct Effort {
  double held = 2;  // simulated seconds of a run
  int runs = 3;
  double precision = 0.03;
  bool processor = false;  // its time counts, not the wall clock's
};

/// What came out of one row on so many threads.
struct Finding {
  const TableRow* row;
  int threads = 1, robots = 0;
  double way = 0;  // forward, of the slowest robot [m]
  WalkingRobots::Shares shares;
};

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Time taken over simulated time: the median of the runs. One that cannot change it any more is left out.
double loadOf(WalkingRobots& robots, const Effort& effort) {
  std::vector<double> loads;
  int below = 0;
  while (static_cast<int>(loads.size()) < effort.runs) {
    const double processor = robots.shares().processor, wall = robots.run(effort.held);
    loads.push_back((effort.processor ? robots.shares().processor - processor : wall) / effort.held);
    below += loads.back() <= 1 ? 1 : 0;
    const int above = static_cast<int>(loads.size()) - below;
    if (2 * std::max(below, above) > effort.runs) return medianOf(loads);
  }
  return medianOf(loads);
}

/// Tries so many robots, tells of it, and keeps in `finding` what the most that were held did.
double tryCount(const RecordedWalk& walk, const WalkingSettings& settings, const Effort& effort, int count,
                Finding& finding) {
  WalkingRobots robots(walk, settings, count);
  const double load = loadOf(robots, effort);
  robots.requireWalk();
  std::fprintf(stderr, "%s, %d threads: %d robots take %.3f of real time, %.3f of processor time\n",
               finding.row->name.c_str(), finding.threads, count, robots.wall() / robots.simulated(),
               robots.shares().processor / robots.simulated());
  if (load <= 1 && count > finding.robots)
    finding.robots = count, finding.way = robots.leastWay(), finding.shares = robots.shares();
  return load;
}

Finding measure(const TableRow& row, const RecordedWalk& walk, int threads, int lanes,
                const TableArguments& arguments) {
  Finding finding{&row, threads, 0, 0, {}};
  const WalkingSettings settings{row.level, row.frame, row.eye, lanes, threads};
  Effort effort = arguments.quick ? Effort{0.1, 1, 0.5} : Effort{};
  effort.processor = arguments.processor;
  const auto load = [&](int count) { return tryCount(walk, settings, effort, count, finding); };
  const bool sees = row.eye != Eye::kNone;
  if (arguments.robots > 0) {
    load(arguments.robots);
  } else {
    largestCount({sees ? 6 : 64, sees ? 1 : 8, effort.precision}, load);
  }
  return finding;
}

std::string sharesText(const WalkingRobots::Shares& shares) {
  double sum = 0;
  for (const double seconds : shares.stage) sum += seconds;
  std::string text;
  for (std::size_t i = 0; i < shares.stage.size(); ++i) {
    const double share = 100 * shares.stage[i] / sum;
    if (share >= 0.5)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", nameOf(static_cast<Stage>(i)), share);
  }
  return text;
}

std::string lineOf(const Finding& finding) {
  const TableRow& row = *finding.row;
  return fmt::format("| {} | {:.0f} Hz{} | {} | {} | {} | {:.2f} | {} |", row.name, 1 / row.frame,
                     row.eye == Eye::kNone ? "" : ", 20 Hz", row.paper ? std::to_string(*row.paper) : "",
                     finding.threads, finding.robots, finding.way, sharesText(finding.shares));
}

/// False, and told, when there is no such row.
bool chooseRows(const std::vector<std::string>& names, std::vector<const TableRow*>& chosen) {
  std::vector<std::string> known;
  for (const TableRow& row : allRows()) known.push_back(row.name);
  bool good = true;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::fprintf(stderr, "--rows: error: unknown row \"%s\"; expected some of: %s%s\n", name.c_str(),
                 fmt::format("{}", fmt::join(known, ", ")).c_str(), didYouMean(name, known).c_str());
    good = false;
  }
  for (const TableRow& row : allRows()) {
    if (names.empty() || std::find(names.begin(), names.end(), row.name) != names.end()) chosen.push_back(&row);
  }
  return good;
}

void write(const std::string& file, const std::vector<Finding>& findings) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    nlohmann::ordered_json paper;
    if (finding.row->paper) paper = *finding.row->paper;
    all.push_back(
        {{"row", finding.row->name}, {"threads", finding.threads}, {"robots", finding.robots}, {"paper", paper}});
  }
  std::ofstream stream(file);
  stream << all.dump(2) << "\n";
  stream.flush();
  if (!stream) throw std::runtime_error(file + ": could not be written");
}

/// Minutes of work are not to end at a file that cannot be written.
bool canWrite(const std::string& file) {
  if (file.empty() || std::ofstream(file, std::ios::app)) return true;
  std::fprintf(stderr, "%s: error: cannot be written\n", file.c_str());
  return false;
}

}  // namespace

int printTable(const TableArguments& arguments) {
  std::vector<const TableRow*> rows;
  if (!chooseRows(arguments.rows, rows) || !canWrite(arguments.json)) return kWrongInput;
  const int lanes = lanesOf(arguments.isa);
  if (lanes < 0) {
    std::fprintf(stderr, "--isa: error: this machine has no AVX-512; expected avx2 or auto\n");
    return kWrongInput;
  }
  if (arguments.processor && (arguments.threads.size() != 1 || arguments.threads.front() != 1)) {
    std::fprintf(stderr, "--processor-time: error: threads share it, expected --threads 1\n");
    return kWrongInput;
  }
  std::printf("%s%s%s\n\n", machineLine(lanes).c_str(), arguments.processor ? ", by processor time" : "",
              arguments.quick ? "; --quick: no figures to be quoted" : "");
  std::puts("| row | motion, camera | paper | threads | robots | forward [m] | share of time |");
  std::puts("|---|---|---|---|---|---|---|");
  const RecordedWalk walk({0.1, 0, 0}, kReplayPeriod);
  std::vector<Finding> findings;
  for (const TableRow* row : rows) {
    for (const int threads : arguments.threads) {
      findings.push_back(measure(*row, walk, threads, lanes, arguments));
      std::puts(lineOf(findings.back()).c_str());
      std::fflush(stdout);
    }
  }
  if (!arguments.json.empty()) write(arguments.json, findings);
  return 0;
}

}  // namespace murosimf
