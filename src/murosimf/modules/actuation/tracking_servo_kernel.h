#pragma once

/// @file Kernel of tracking_servo.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/actuation/joint_goal.h"

namespace murosimf {

struct TrackingServoArguments {
  int joints = 0;
  ColumnRef command, position, velocity, lower, upper, largest_velocity, eagerness, demand;
  ColumnRef largest_acceleration;  ///< [rad/s^2]; 0: any
};

void addBaselineKernels(KernelSet<TrackingServoArguments>& kernels);
void addWideKernels(KernelSet<TrackingServoArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// The rate nearest to `wanted` that differs from dq by no more than `change`, and from which steps of that change stop
/// the joint within its way: v (v/change + 1)/2 <= |w|, w the rate that would take one step for it.
template <class S>
inline S gentleRate(S wanted, S dq, S w, S change) {
  const S half = S(0.5) * change;
  const S most = sqrt(fma(half, half, S(2) * change * abs(w))) - half;
  return clamp(clamp(wanted, -most, most), dq - change, dq + change);
}

template <class S>
void trackingServo(const TrackingServoArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* command = columnAt<CommandLanes<S>, S>(block, a.command);
  const S *q = columnAt<S, S>(block, a.position), *dq = columnAt<S, S>(block, a.velocity);
  const S *lower = columnAt<S, S>(block, a.lower), *upper = columnAt<S, S>(block, a.upper);
  const S *fastest = columnAt<S, S>(block, a.largest_velocity), *eagerness = columnAt<S, S>(block, a.eagerness);
  S* demand = columnAt<S, S>(block, a.demand);
  const S* largest_acceleration = columnAt<S, S>(block, a.largest_acceleration);
  const S per_step(1 / time.dt), dt(time.dt);
  for (int j = 0; j < a.joints; ++j) {
    const JointGoal<S> goal = jointGoal(command[j], q[j], lower[j], upper[j], fastest[j]);
    const S way = goal.position - q[j];
    const S rate = clamp(way * min(per_step, eagerness[j]), -goal.speed, goal.speed);
    const S change = largest_acceleration[j] * dt;
    const S followed = select(change > S(0), gentleRate(rate, dq[j], way * per_step, change), rate);
    const auto has_rate = hasRate(command[j]);
    demand[j] = followed;
    if (!any(has_rate)) continue;
    const S wanted = wantedRate(command[j], q[j], lower[j], upper[j], fastest[j], per_step);
    const S gentle = select(change > S(0), clamp(wanted, dq[j] - change, dq[j] + change), wanted);
    demand[j] = select(has_rate, gentle, followed);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
