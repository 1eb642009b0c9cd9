#pragma once

/// @file The largest number of robots that a machine simulates in real time, found by trying numbers.
///
/// Every number that counts is one that was tried: what lies between is never computed. Where to try next is guessed
/// from the load of the last trial, in proportion, and kept between what was held and what was not.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace murosimf {

struct CountSearch {
  int first = 8;            ///< the first number that is tried
  int step = 1;             ///< numbers are multiples of it
  double precision = 0.03;  ///< ends when the next larger number that failed is at most so much larger
  double fastest = 16;      ///< no number is more than so many times the one before
};

/// @param load  wall time over simulated time with so many robots; at most 1: they are held
/// @return the largest number that was tried and held; 0: not even `step` of them
inline int largestCount(const CountSearch& search, const std::function<double(int)>& load) {
  constexpr int kNone = std::numeric_limits<int>::max();
  int held = 0, failed = kNone, count = search.first;
  const auto rounded = [&](double n) { return std::max(search.step, static_cast<int>(n / search.step) * search.step); };
  for (;;) {
    const double found = load(count);
    if (found <= 1) {
      held = std::max(held, count);
    } else {
      failed = std::min(failed, count);
    }
    if (failed <= held + std::max<double>(search.step, search.precision * held)) return held;
    double next = std::min(count / std::max(found, 1e-6), search.fastest * count);
    if (failed == kNone) {
      next = std::max(next, count * (1 + search.precision));
      count = std::max(rounded(next), count + search.step);
      continue;
    }
    // Not right beside what is known: a trial there would tell little where loads are not in proportion.
    const double width = failed - held, edge = std::max(0.4 * search.precision * held, 0.1 * width);
    count = rounded(std::clamp(next, held + edge, failed - edge));
    if (count <= held) count = held + search.step;
    if (count >= failed) count = failed - search.step;
  }
}

}  // namespace murosimf
