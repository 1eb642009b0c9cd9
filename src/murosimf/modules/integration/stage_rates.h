#pragma once

/// @file The rates of all coordinates of a robot at the stages of a step, and their weighted sums.

#include "murosimf/math/vec3.h"
#include "murosimf/modules/integration/dormand_prince_tableau.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// k_1 ... k_7 of one coordinate.
template <class S = double>
struct StageRates {
  S k[kDormandPrinceStages];
};
template <class S = double>
struct JointRates {
  StageRates<S> q, dq;
};
/// Of the base's chart (base_chart.h) and of its velocity.
template <class S = double>
struct BaseRates {
  StageRates<S> phi[3], p[3], w[3], v[3];
};

template <class S>
inline S weighted(const StageRates<S>& rates, const StageWeights<S>& weights, int stages) {
  S sum = weights.of[0] * rates.k[0];
  for (int i = 1; i < stages; ++i) sum = fma(weights.of[i], rates.k[i], sum);
  return sum;
}
template <class S>
inline Vec3<S> weighted(const StageRates<S> (&rates)[3], const StageWeights<S>& weights, int stages) {
  return {weighted(rates[0], weights, stages), weighted(rates[1], weights, stages),
          weighted(rates[2], weights, stages)};
}
template <class S>
inline void keep(StageRates<S> (&rates)[3], int stage, const Vec3<S>& value) {
  for (int i = 0; i < 3; ++i) rates[i].k[stage] = value[i];
}
template <class S, class Truth>
inline void keepWhere(Truth mask, StageRates<S> (&rates)[3], const Vec3<S>& value) {
  for (int i = 0; i < 3; ++i) rates[i].k[0] = select(mask, value[i], rates[i].k[0]);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
