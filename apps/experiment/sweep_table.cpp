#include "experiment/sweep_table.h"

#include <algorithm>

namespace murosimf {

namespace {

class Collector {
 public:
  Collector(const SweepPlan& plan, const std::vector<BatchRun>& runs, const ResultStore& store)
      : plan_(plan), runs_(runs), store_(store), problems_(plan.metrics.size()), found_(plan.metrics.size(), false) {}

  SweepTable collect(Diagnostics& diagnostics) {
    SweepTable table;
    for (std::size_t c = 0; c < plan_.cases.size(); ++c) table.rows.push_back(collectCase(c, table.lines));
    for (std::size_t m = 0; m < plan_.metrics.size(); ++m)
      if (!found_[m] && !problems_[m].empty()) diagnostics.error(plan_.metrics[m].where, problems_[m]);
    return table;
  }

 private:
  SweepRow collectCase(std::size_t number, std::vector<SweepLine>& lines) {
    SweepRow row;
    row.labels = plan_.cases[number].labels;
    row.cells.resize(plan_.metrics.size());
    for (std::size_t s = 0; s < plan_.seeds.size(); ++s) {
      SweepLine& line = lines.emplace_back();
      line.labels = row.labels;
      line.seed = plan_.seeds[s];
      line.values.resize(plan_.metrics.size());
      ++row.runs;
      const std::optional<RunResult> result = store_.read(runs_[number * plan_.seeds.size() + s].identity);
      line.missing = !result;
      if (result) line.failure = result->failure;
      row.missing += line.missing ? 1 : 0;
      row.failed += line.failure.empty() ? 0 : 1;
      if (!result || !result->failure.empty()) continue;
      ++row.done;
      line.state_hash = result->report.value("state_hash", "");
      measure(result->report, row, line);
    }
    for (SweepCell& cell : row.cells)
      cell.estimate =
          cell.is_rate ? estimateRate(cell.values, plan_.confidence) : estimateMean(cell.values, plan_.confidence);
    return row;
  }

  void measure(const nlohmann::ordered_json& report, SweepRow& row, SweepLine& line) {
    for (std::size_t m = 0; m < plan_.metrics.size(); ++m) {
      const Metric& metric = *plan_.metrics[m];
      const std::optional<MetricValue> value = metric.read(report);
      const std::string problem = value ? "" : metric.problem(report);
      if (problem.empty()) found_[m] = true;
      if (problems_[m].empty()) problems_[m] = problem;
      row.cells[m].unmeasured += value ? 0 : 1;
      if (!value) continue;
      line.values[m] = value->number;
      row.cells[m].values.push_back(value->number);
      row.cells[m].is_rate = value->is_truth;
    }
  }

  const SweepPlan& plan_;
  const std::vector<BatchRun>& runs_;
  const ResultStore& store_;
  std::vector<std::string> problems_;  // a metric each: why a report lacks it
  std::vector<bool> found_;            // a metric each: some report has it
};

int sumOf(const SweepTable& table, int SweepRow::*count) {
  int sum = 0;
  for (const SweepRow& row : table.rows) sum += row.*count;
  return sum;
}

}  // namespace

int SweepTable::failed() const { return sumOf(*this, &SweepRow::failed); }
int SweepTable::missing() const { return sumOf(*this, &SweepRow::missing); }

SweepTable collectSweep(const SweepPlan& plan, const std::vector<BatchRun>& runs, const ResultStore& store,
                        Diagnostics& diagnostics) {
  return Collector(plan, runs, store).collect(diagnostics);
}

}  // namespace murosimf
