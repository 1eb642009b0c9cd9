#pragma once

/// @file The method of Dormand and Prince of order 5 with an estimate of order 4, and its path of order 4.
///
///   k_i = f(y_0 + h sum_j a_ij k_j),  i = 1 ... 7;   y_1 = y_0 + h sum_j a_7j k_j, so that k_7 = f(y_1)
///   estimated error of y_1:     h sum_i e_i k_i
///   y(theta) between y_0 and y_1, and a little beyond:  y_0 + h sum_i w_i(theta) k_i
///
/// Sources: [Dormand & Prince 1980]; the path [Hairer, Norsett, Wanner 1993, II.6].

#include "murosimf/math/pack.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

inline constexpr int kDormandPrinceStages = 7;

/// c_i: share of the step at which stage i, counted from 0, stands.
inline constexpr double kStageShare[kDormandPrinceStages] = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};

/// a_ij.
inline constexpr double kStageWeight[kDormandPrinceStages][kDormandPrinceStages - 1] = {
    {0, 0, 0, 0, 0, 0},
    {1.0 / 5, 0, 0, 0, 0, 0},
    {3.0 / 40, 9.0 / 40, 0, 0, 0, 0},
    {44.0 / 45, -56.0 / 15, 32.0 / 9, 0, 0, 0},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729, 0, 0},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656, 0},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};

/// e_i.
inline constexpr double kErrorWeight[kDormandPrinceStages] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                                              -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

/// Of the term of fourth order of the path.
inline constexpr double kPathWeight[kDormandPrinceStages] = {
    -12715105075.0 / 11282082432.0,  0,
    87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0};

/// Seven factors, one a stage.
template <class S>
struct StageWeights {
  S of[kDormandPrinceStages];
};

/// Those that place stage i; stages from i on count 0.
template <class S>
inline StageWeights<S> stageWeights(int stage) {
  StageWeights<S> w;
  for (int j = 0; j < kDormandPrinceStages; ++j) w.of[j] = S(j < stage ? kStageWeight[stage][j] : 0.0);
  return w;
}
template <class S>
inline StageWeights<S> errorWeights() {
  StageWeights<S> w;
  for (int j = 0; j < kDormandPrinceStages; ++j) w.of[j] = S(kErrorWeight[j]);
  return w;
}

/// w(theta): at theta = 1 those of the step itself, to the bit. With b = a_7, and d the weights of fourth order,
///   w_i = theta (b_i + (1 - theta) (s_i + theta (b_i - l_i - s_i + (1 - theta) d_i))),   s_i = f_i - b_i
/// where f is 1 for the first stage and l for the last, else 0.
template <class S>
inline StageWeights<S> pathWeights(S theta) {
  StageWeights<S> w;
  const S rest = S(1) - theta;
  for (int j = 0; j < kDormandPrinceStages; ++j) {
    const bool first = j == 0, last = j + 1 == kDormandPrinceStages;
    const double b = last ? 0.0 : kStageWeight[kDormandPrinceStages - 1][j];
    const double start = (first ? 1.0 : 0.0) - b, turn = b - (last ? 1.0 : 0.0) - start;
    const S bend = fma(theta, fma(rest, S(kPathWeight[j]), S(turn)), S(start));
    w.of[j] = theta * fma(rest, bend, S(b));
  }
  return w;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
