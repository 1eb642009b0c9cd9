#pragma once

/// @file Percentiles of a long row of numbers from a bounded store.
///
/// Every stride-th number is kept. When the store is full, every second one is dropped and the stride doubles: the kept
/// ones are always spread evenly over the whole row, and nothing is allocated after construction.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "murosimf/math/state_archive.h"

namespace murosimf {

/// The p-quantile (0 <= p <= 1) of numbers, linear between order statistics: rank p (n - 1) from the smallest, 0. NaN
/// when there are none.
inline double percentile(std::vector<float> numbers, double p) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(numbers.begin(), numbers.end());
  const double rank = p * static_cast<double>(numbers.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, numbers.size() - 1);
  const double low = numbers[below], high = numbers[above];
  return low + (rank - static_cast<double>(below)) * (high - low);
}

class Samples {
 public:
  explicit Samples(std::size_t capacity = 1 << 14) : capacity_(std::max<std::size_t>(capacity, 2)) {
    kept_.reserve(capacity_);
  }

  void add(double number) {
    if (seen_++ % stride_ != 0) return;
    if (kept_.size() == capacity_) {
      thin();
      if ((seen_ - 1) % stride_ != 0) return;
    }
    kept_.push_back(static_cast<float>(number));
  }
  std::size_t seen() const { return seen_; }
  const std::vector<float>& kept() const { return kept_; }
  void archive(StateArchive& archive) { archive(kept_, seen_, stride_); }

 private:
  void thin() {
    std::size_t to = 0;
    for (std::size_t from = 0; from < kept_.size(); from += 2) kept_[to++] = kept_[from];
    kept_.resize(to);
    stride_ *= 2;
  }

  std::size_t capacity_, seen_ = 0, stride_ = 1;
  std::vector<float> kept_;
};

}  // namespace murosimf
