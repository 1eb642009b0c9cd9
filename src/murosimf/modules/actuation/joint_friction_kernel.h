#pragma once

/// @file Kernel of joint_friction.h.

#include "murosimf/algorithms/dry_friction.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct JointFrictionArguments {
  int joints = 0;
  double stick_speed = 0;  ///< [rad/s]
  ColumnRef velocity, velocity_last, friction, stribeck, stribeck_speed, torque, inertia;
};

void addBaselineKernels(KernelSet<JointFrictionArguments>& kernels);
void addWideKernels(KernelSet<JointFrictionArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void jointFriction(const JointFrictionArguments& a, const BlockMemory& block, const StepTime& time) {
  const S* dq = columnAt<S, S>(block, a.velocity);
  S* dq_last = columnAt<S, S>(block, a.velocity_last);
  const S *friction = columnAt<S, S>(block, a.friction), *stribeck = columnAt<S, S>(block, a.stribeck);
  const S* stribeck_speed = columnAt<S, S>(block, a.stribeck_speed);
  S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  const S stick_speed(a.stick_speed), zero(0);
  for (int j = 0; j < a.joints; ++j) {
    S f = friction[j];
    const auto sticky = stribeck[j] > zero;
    if (any(sticky)) {
      const S ratio = dq[j] / stribeck_speed[j];
      f = select(sticky, fma(stribeck[j], exp(-(ratio * ratio)), f), f);
    }
    const ImplicitTorque<S> dry = dryFriction(f, dq[j], dq_last[j], stick_speed, time.implicit);
    dq_last[j] = dq[j];
    torque[j] += dry.torque;
    inertia[j] += dry.inertia;
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
