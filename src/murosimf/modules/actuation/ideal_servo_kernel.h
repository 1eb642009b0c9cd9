#pragma once

/// @file Kernel of ideal_servo.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/actuation/joint_goal.h"

namespace murosimf {

struct IdealServoArguments {
  int joints = 0;
  ColumnRef command, position, velocity, lower, upper, largest_velocity;
};

void addBaselineKernels(KernelSet<IdealServoArguments>& kernels);
void addWideKernels(KernelSet<IdealServoArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void idealServo(const IdealServoArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* command = columnAt<CommandLanes<S>, S>(block, a.command);
  S* q = columnAt<S, S>(block, a.position);
  S* v = columnAt<S, S>(block, a.velocity);
  const S* lower = columnAt<S, S>(block, a.lower);
  const S* upper = columnAt<S, S>(block, a.upper);
  const S* fastest = columnAt<S, S>(block, a.largest_velocity);
  const S dt(time.dt);
  for (int j = 0; j < a.joints; ++j) {
    const JointGoal<S> goal = jointGoal(command[j], q[j], lower[j], upper[j], fastest[j]);
    const S limit = goal.speed * dt, difference = goal.position - q[j];
    const S followed = select(abs(difference) <= limit, goal.position, q[j] + withSignOf(limit, difference));
    const S wanted = wantedRate(command[j], q[j], lower[j], upper[j], fastest[j], S(1 / time.dt));
    const S next = select(hasRate(command[j]), fma(wanted, dt, q[j]), followed);
    v[j] = (next - q[j]) / dt;
    q[j] = next;
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
