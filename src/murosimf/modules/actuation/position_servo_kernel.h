#pragma once

/// @file Kernel of position_servo.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/actuation/command_lanes.h"
#include "murosimf/modules/actuation/gear_play.h"

namespace murosimf {

struct PositionServoArguments {
  int joints = 0;
  ColumnRef demand, position, velocity, stall_torque, no_load_speed, backlash, torque, inertia;
};

void addBaselineKernels(KernelSet<PositionServoArguments>& kernels);
void addWideKernels(KernelSet<PositionServoArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void positionServo(const PositionServoArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* demand = columnAt<CommandLanes<S>, S>(block, a.demand);
  const S *q = columnAt<S, S>(block, a.position), *dq = columnAt<S, S>(block, a.velocity);
  const S *stall = columnAt<S, S>(block, a.stall_torque), *fastest = columnAt<S, S>(block, a.no_load_speed);
  const S* backlash = columnAt<S, S>(block, a.backlash);
  S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  const S h(time.implicit), zero(0), one(1);
  for (int j = 0; j < a.joints; ++j) {
    const S kp = demand[j].kp, kd = demand[j].kd;
    const S error = demand[j].position - fma(h, dq[j], q[j]);  // as it will be if the joint goes on like this
    S wanted = fma(kp, error, fnma(kd, dq[j], demand[j].torque));
    const auto plays = (backlash[j] > zero) & (kp > zero);
    auto loose = plays;
    if (any(plays)) {
      const S beyond = beyondPlay(error + demand[j].torque / kp, backlash[j]);
      wanted = select(plays, fma(kp, beyond, -(kd * dq[j])), wanted);
      loose = plays & isLoose(beyond, wanted);
      wanted = select(loose, zero, wanted);
    }
    const S share = dq[j] / fastest[j];
    const S most = stall[j] * clamp(one - share, zero, one), least = -(stall[j] * clamp(one + share, zero, one));
    const S given = clamp(wanted, least, most);
    torque[j] += given;
    inertia[j] += select((given < wanted) | (given > wanted) | loose, zero, h * fma(h, kp, kd));
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
