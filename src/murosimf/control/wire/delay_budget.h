#pragma once

/// @file How long a game in lock-step waits for one robot's client [after the delay budget of the DARPA VRC].
///
/// An answer within `patience` costs nothing. What it takes beyond is charged to a budget of so many seconds within any
/// `window`. A client that does not answer even so is not waited for again until it has answered. Wall clock, in s.

#include <deque>
#include <utility>

namespace murosimf {

struct DelayLimits {
  double patience = 0.1;  ///< a step
  double budget = 1.0;    ///< beyond it, within any window
  double window = 25.0;
};

class DelayBudget {
 public:
  explicit DelayBudget(const DelayLimits& limits) : limits_(limits) {}

  /// How long to wait for an answer that is asked for now.
  double allowance(double now);
  /// The answer came after this long.
  void answered(double now, double waited);
  /// It has not come.
  void missed(double now, double waited);
  bool isLost() const { return lost_; }
  /// Answers that did not come in time.
  long misses() const { return misses_; }

 private:
  void charge(double now, double waited);

  DelayLimits limits_;
  std::deque<std::pair<double, double>> charges_;  // when, how much
  bool lost_ = false;
  long misses_ = 0;
};

}  // namespace murosimf
