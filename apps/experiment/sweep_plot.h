#pragma once

/// @file The results of a sweep as a picture (SVG): a panel a metric, means with their confidence intervals.

#include <string>

#include "experiment/sweep_table.h"

namespace murosimf {

/// Over the last axis of the plan whose values are all numbers, a line for each combination of the others; where there
/// is none, one row a case. The same bytes for the same table.
std::string sweepPlot(const SweepPlan& plan, const SweepTable& table);

}  // namespace murosimf
