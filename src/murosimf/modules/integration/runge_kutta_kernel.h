#pragma once

/// @file Kernel of runge_kutta.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/integration/base_chart.h"

namespace murosimf {

/// One stage of a method of which each stage starts from the rates of the one before.
struct RungeKuttaStage {
  bool first = false, last = false;
  double weight = 1;  ///< of this stage's rates in the step
  double next = 0;    ///< share of the step to which they carry the next stage
  int joints = 0;
  ColumnRef q, dq, base_pose, base_velocity;          // the state of the moment
  ColumnRef joint_acceleration, acceleration, up;     // evaluated in it
  ColumnRef q_0, dq_0, base_pose_0, base_velocity_0;  // at the beginning of the step
  ColumnRef q_sum, dq_sum, change_sum, velocity_sum;  // weighted rates so far
  ColumnRef change;                                   // of the pose since the beginning
};

void addBaselineKernels(KernelSet<RungeKuttaStage>& kernels);
void addWideKernels(KernelSet<RungeKuttaStage>& kernels);

inline namespace MUROSIMF_ISA {

/// y = y_0 + h (next rate), or on the last stage y = y_0 + h sum; sum takes the rate with its weight.
template <class S, class T>
inline void advanceValue(const RungeKuttaStage& a, S h, T& y, T& y_0, T& sum, const T& rate) {
  if (a.first) y_0 = y, sum = rate * S(a.weight);
  if (!a.first) sum += rate * S(a.weight);
  y = y_0;
  y += a.last ? sum * h : rate * (h * S(a.next));
}

template <class S>
inline void advanceBase(const RungeKuttaStage& a, const BlockMemory& block, S h) {
  auto& X = *columnAt<Transform<S>, S>(block, a.base_pose);
  auto& X_0 = *columnAt<Transform<S>, S>(block, a.base_pose_0);
  auto& V = *columnAt<SpatialMotion<S>, S>(block, a.base_velocity);
  auto& change = *columnAt<BaseChange<S>, S>(block, a.change);
  auto& sum = *columnAt<BaseChange<S>, S>(block, a.change_sum);
  const Vec3<S> zero{S(0), S(0), S(0)};
  if (a.first) X_0 = X, change = {zero, zero};
  const BaseChange<S> rate = rateOf(change, X.rotation, V);
  if (a.first) sum = rate * S(a.weight);
  if (!a.first) sum += rate * S(a.weight);
  change = a.last ? sum * h : rate * (h * S(a.next));
  X = changed(X_0, change);
  if (a.last) X.rotation = orthonormalized(X.rotation);
  const SpatialMotion<S> proper = *columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  const Vec3<S> up = *columnAt<Vec3<S>, S>(block, a.up);
  advanceValue(a, h, V, *columnAt<SpatialMotion<S>, S>(block, a.base_velocity_0),
               *columnAt<SpatialMotion<S>, S>(block, a.velocity_sum), trueAcceleration(proper, up));
}

template <class S>
void rungeKuttaStage(const RungeKuttaStage& a, const BlockMemory& block, const StepTime& time) {
  const S h(time.dt);
  S *q = columnAt<S, S>(block, a.q), *q_0 = columnAt<S, S>(block, a.q_0), *q_sum = columnAt<S, S>(block, a.q_sum);
  S *dq = columnAt<S, S>(block, a.dq), *dq_0 = columnAt<S, S>(block, a.dq_0);
  S* dq_sum = columnAt<S, S>(block, a.dq_sum);
  const S* ddq = columnAt<S, S>(block, a.joint_acceleration);
  for (int j = 0; j < a.joints; ++j) {
    const S rate = dq[j];
    advanceValue(a, h, dq[j], dq_0[j], dq_sum[j], ddq[j]);
    advanceValue(a, h, q[j], q_0[j], q_sum[j], rate);
  }
  advanceBase(a, block, h);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
