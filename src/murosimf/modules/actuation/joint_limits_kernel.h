#pragma once

/// @file Kernel of joint_limits.h.

#include "murosimf/linking/kernel.h"

namespace murosimf {

struct JointLimitArguments {
  int joints = 0;
  double per_give = 0;       ///< 1 / give [1/rad]
  double damping_ratio = 0;  ///< of the bare rotor
  ColumnRef position, velocity, lower, upper, stall_torque, armature, stiffness, damping, torque, inertia;
};

/// Stall torque [N m] and armature [kg m^2] that count for joints with less.
inline constexpr double kLeastStopTorque = 1, kLeastStopArmature = 1e-3;

void addBaselineKernels(KernelSet<JointLimitArguments>& kernels);
void addWideKernels(KernelSet<JointLimitArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void jointLimits(const JointLimitArguments& a, const BlockMemory& block, const StepTime& time) {
  const S *q = columnAt<S, S>(block, a.position), *dq = columnAt<S, S>(block, a.velocity);
  const S *lower = columnAt<S, S>(block, a.lower), *upper = columnAt<S, S>(block, a.upper);
  const S *stall = columnAt<S, S>(block, a.stall_torque), *armature = columnAt<S, S>(block, a.armature);
  const S *stiffness = columnAt<S, S>(block, a.stiffness), *damping = columnAt<S, S>(block, a.damping);
  S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  const S h(time.implicit), zero(0);
  for (int j = 0; j < a.joints; ++j) {
    const S ahead = fma(h, dq[j], q[j]);  // where the joint will be if it goes on like this
    const auto above = ahead > upper[j], below = ahead < lower[j];
    if (!any(above | below)) continue;
    const S of_stall = max(stall[j], S(kLeastStopTorque)) * S(a.per_give);
    const S k = select(stiffness[j] > zero, stiffness[j], of_stall);
    const S of_rotor = S(2 * a.damping_ratio) * sqrt(k * max(armature[j], S(kLeastStopArmature)));
    const S c = select(damping[j] > zero, damping[j], of_rotor);
    const S depth = select(above, ahead - upper[j], lower[j] - ahead);
    const S push = fma(k, depth, c * select(above, dq[j], -dq[j]));
    const auto pushes = (above | below) & (push > zero);
    torque[j] = select(pushes, torque[j] + select(above, -push, push), torque[j]);
    inertia[j] = select(pushes, inertia[j] + h * fma(h, k, c), inertia[j]);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
