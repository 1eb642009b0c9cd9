#pragma once

/// @file Whether a metric stays the same, within a tolerance, when something is simulated more cheaply.
///
/// An equivalence test: not "no difference was found", which few runs always grant, but "the difference is found to be
/// small". Two one-sided tests [Schuirmann 1987]: the difference is within (-tolerance, tolerance) with probability of
/// error 1 - c at most when its interval of confidence 2 c - 1 lies there. Runs are compared seed by seed.
/// Numbers: Student's interval of the mean difference. Verdicts, true or false: Tango's interval of the difference of
/// the two rates, which has a width even where all pairs agree.

#include <optional>
#include <vector>

#include "experiment/metric.h"
#include "experiment/statistics.h"

namespace murosimf {

/// One measurement a seed; nothing where it was not measured.
using Measurements = std::vector<std::optional<MetricValue>>;

struct Comparison {
  Estimate difference;      ///< candidate less reference
  bool equivalent = false;  ///< the whole interval lies within the tolerance
  bool different = false;   ///< no part of the interval does: more seeds will not help
  int unmatched = 0;        ///< seeds measured in one of both alone: a difference in itself, never equivalent
};

struct EquivalenceTest {
  double tolerance = 0;     ///< > 0
  double confidence = .95;  ///< c of each of the two tests, in (1/2, 1)

  /// The candidate may have fewer seeds than the reference: the first of them are compared.
  Comparison compare(const Measurements& reference, const Measurements& candidate) const;
  /// Half of the interval of verdicts that agree in all of n pairs: no tolerance below it can be met. z^2 / (n + z^2).
  double leastTolerance(long pairs) const;
};

}  // namespace murosimf
