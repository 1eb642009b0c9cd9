#pragma once

/// @file The results of a sweep: per case and metric the mean or rate over all seeds with its confidence interval.
///
/// Made of what results hold besides clocks, in the plan's order: the same bytes whoever played, in which order,
/// however often it was interrupted. What is missing is counted, never left out in silence.

#include <optional>
#include <string>
#include <vector>

#include "experiment/result_store.h"
#include "experiment/statistics.h"
#include "experiment/sweep_plan.h"

namespace murosimf {

/// One case and one metric.
struct SweepCell {
  std::vector<double> values;  ///< of those runs that measured it, in the order of seeds
  bool is_rate = false;        ///< of true and false
  int unmeasured = 0;          ///< runs that are done but say null or lack it
  Estimate estimate;           ///< of the values
};

struct SweepRow {
  std::vector<std::string> labels;  ///< as in the plan's cases
  int runs = 0, done = 0, failed = 0, missing = 0;
  std::vector<SweepCell> cells;  ///< one a metric of the plan
};

/// One run.
struct SweepLine {
  std::vector<std::string> labels;
  std::uint64_t seed = 0;
  bool missing = false;
  std::string failure, state_hash;
  std::vector<std::optional<double>> values;  ///< one a metric of the plan
};

struct SweepTable {
  std::vector<SweepRow> rows;    ///< one a case
  std::vector<SweepLine> lines;  ///< one a run
  int failed() const;
  int missing() const;
};

/// @param runs  runsOf(plan)
/// A metric that no report has is an error, with the nearest that they have.
SweepTable collectSweep(const SweepPlan& plan, const std::vector<BatchRun>& runs, const ResultStore& store,
                        Diagnostics& diagnostics);

/// One line a case and metric, all digits. Fields with commas or quotes stand in quotes [RFC 4180].
std::string tableCsv(const SweepPlan& plan, const SweepTable& table);
/// One line a run.
std::string runsCsv(const SweepPlan& plan, const SweepTable& table);
std::string tableJson(const SweepPlan& plan, const SweepTable& table);
/// For people: one line a case, "mean [low, high]" a metric, and below it what is missing.
std::string tableMarkdown(const SweepPlan& plan, const SweepTable& table);

}  // namespace murosimf
