#include "murosimf/modules/camera/random_events.h"

#include <cmath>

namespace murosimf {

namespace {

constexpr int kMostEvents = 64;

/// Whether an outage that began in window j lasts at x, in lengths of a window.
bool lastsFrom(const RandomStream& stream, double j, double x, double mean) {
  if (j < 0) return false;
  const auto first = static_cast<std::uint64_t>(j) * (kMostEvents + 1);
  const int count = poissonCount(stream.uniform(first), mean);
  for (int i = 1; i <= count; ++i) {
    const double start = j + stream.uniform(first + static_cast<std::uint64_t>(i));
    if (start <= x && x < start + 1) return true;
  }
  return false;
}

}  // namespace

int poissonCount(double uniform, double mean) {
  double share = exp(-mean), sum = share;
  int count = 0;
  while (uniform >= sum && count < kMostEvents) {
    ++count;
    share *= mean / count;
    sum += share;
  }
  return count;
}

bool isOutage(const RandomStream& stream, double t, double rate, double length) {
  if (!(rate > 0 && length > 0)) return false;
  const double x = t / length, window = std::floor(x);
  return lastsFrom(stream, window, x, rate * length) || lastsFrom(stream, window - 1, x, rate * length);
}

}  // namespace murosimf
