#pragma once

/// @file Kernel of position_servo.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/actuation/command_lanes.h"

namespace murosimf {

struct PositionServoArguments {
  int joints = 0;
  ColumnRef demand, position, velocity, stall_torque, no_load_speed, torque, inertia;
};

void addBaselineKernels(KernelSet<PositionServoArguments>& kernels);
void addWideKernels(KernelSet<PositionServoArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void positionServo(const PositionServoArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* demand = columnAt<CommandLanes<S>, S>(block, a.demand);
  const S *q = columnAt<S, S>(block, a.position), *dq = columnAt<S, S>(block, a.velocity);
  const S *stall = columnAt<S, S>(block, a.stall_torque), *fastest = columnAt<S, S>(block, a.no_load_speed);
  S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  const S h(time.implicit), zero(0), one(1);
  for (int j = 0; j < a.joints; ++j) {
    const S kp = demand[j].kp, kd = demand[j].kd;
    const S ahead = fma(h, dq[j], q[j]);  // where the joint will be if it goes on like this
    const S wanted = fma(kp, demand[j].position - ahead, fnma(kd, dq[j], demand[j].torque));
    const S share = dq[j] / fastest[j];
    const S most = stall[j] * clamp(one - share, zero, one), least = -(stall[j] * clamp(one + share, zero, one));
    const S given = clamp(wanted, least, most);
    torque[j] += given;
    inertia[j] += select((given < wanted) | (given > wanted), zero, h * fma(h, kp, kd));
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
