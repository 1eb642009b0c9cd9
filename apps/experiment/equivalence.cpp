#include "experiment/equivalence.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

Comparison EquivalenceTest::compare(const Measurements& reference, const Measurements& candidate) const {
  Comparison out;
  std::vector<double> a, b, differences;
  bool verdicts = false;
  for (std::size_t i = 0; i < std::min(reference.size(), candidate.size()); ++i) {
    out.unmatched += reference[i].has_value() != candidate[i].has_value() ? 1 : 0;
    if (!reference[i] || !candidate[i]) continue;
    verdicts = verdicts || reference[i]->is_truth;
    a.push_back(reference[i]->number);
    b.push_back(candidate[i]->number);
    differences.push_back(b.back() - a.back());
  }
  const double interval = 2 * confidence - 1;
  out.difference = verdicts ? estimateRateDifference(a, b, interval) : estimateMean(differences, interval);
  const Interval& range = out.difference.interval;
  out.equivalent = out.unmatched == 0 && -tolerance < range.low && range.high < tolerance;
  out.different = range.low > tolerance || range.high < -tolerance;
  return out;
}

double EquivalenceTest::leastTolerance(long pairs) const {
  const double z = normalQuantile(confidence);
  return z * z / (static_cast<double>(pairs) + z * z);
}

}  // namespace murosimf
