#pragma once

/// @file Two ways of doing the same work, compared by the ratio of their times.
///
/// Machines slow down and speed up by factors while others use them, so times of different sittings do not compare.
/// Both ways run in turns, a few milliseconds each; the median of the ratios of the rounds is the result.

#include <functional>
#include <string>
#include <vector>

namespace murosimf::bench {

/// One row of the report.
struct Row {
  std::string name;
  double ratio = 0;           ///< peer over ours: how many times faster ours is
  double ours = 0, peer = 0;  ///< medians
  std::string unit;           ///< of `ours` and `peer`
  std::string isa;            ///< instruction set of ours
  std::string text;           ///< for people
};

/// Seconds of a clock that is cheap to read. What interrupts a round is an outlier that the median drops.
double now();

/// Medians over rounds. Each of `ours` and `peer` does one round's work and returns the seconds that count.
struct Comparison {
  double ratio = 0, ours = 0, peer = 0;
};
Comparison compare(const std::function<double()>& ours, const std::function<double()>& peer, int rounds);

/// The instruction set that kernels of the widest lanes use on this machine.
std::string widestIsa();
int widestLanes();

/// The comparisons, in the order of the report. One function a file of bench/.
std::vector<Row> kinematicRows();

}  // namespace murosimf::bench
