#pragma once

/// @file Kernel of servo_controller.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/modules/actuation/command_lanes.h"

namespace murosimf {

struct ServoControllerArguments {
  int joints = 0;
  ColumnRef command, position, lower, upper, kp, kd, demand;
};

void addBaselineKernels(KernelSet<ServoControllerArguments>& kernels);
void addWideKernels(KernelSet<ServoControllerArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void controlServos(const ServoControllerArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* command = columnAt<CommandLanes<S>, S>(block, a.command);
  auto* demand = columnAt<CommandLanes<S>, S>(block, a.demand);
  const S* q = columnAt<S, S>(block, a.position);
  const S *lower = columnAt<S, S>(block, a.lower), *upper = columnAt<S, S>(block, a.upper);
  const S *kp = columnAt<S, S>(block, a.kp), *kd = columnAt<S, S>(block, a.kd);
  const S zero(0);
  for (int j = 0; j < a.joints; ++j) {
    const auto on = command[j].kp > zero;
    const auto was_on = demand[j].kp > zero;
    const S from = select(was_on, demand[j].position, q[j]);
    const S wanted = clamp(command[j].position, lower[j], upper[j]);
    const S way = wanted - from, limit = command[j].velocity * S(time.dt);
    const auto slow = (command[j].velocity > zero) & (abs(way) > limit);
    const S reached = select(slow, from + withSignOf(limit, way), wanted);
    demand[j].position = select(on, reached, q[j]);
    demand[j].velocity = zero;
    demand[j].torque = command[j].torque;
    demand[j].kp = select(on, kp[j], zero);
    demand[j].kd = select(on, kd[j], zero);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
