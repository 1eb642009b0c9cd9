#pragma once

/// @file Kernel of servo_controller.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/math/bits.h"
#include "murosimf/modules/actuation/command_lanes.h"

namespace murosimf {

/// Commands that are on their way: a ring, one place a step.
inline constexpr int kCommandPlaces = 32;

struct ServoControllerArguments {
  int joints = 0, delay_steps = 0;
  bool commanded_gains = false, encoder_steps = false;
  ColumnRef command, position, lower, upper, kp, kd, resolution, held, demand, on_the_way;
};

void addBaselineKernels(KernelSet<ServoControllerArguments>& kernels);
void addWideKernels(KernelSet<ServoControllerArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// The command of `delay_steps` steps ago; puts the new one on its way.
template <class S>
inline CommandLanes<S> delayed(const ServoControllerArguments& a, const BlockMemory& block, int j, double t,
                               double dt) {
  const CommandLanes<S> command = columnAt<CommandLanes<S>, S>(block, a.command)[j];
  if (a.delay_steps == 0) return command;
  CommandLanes<S>* ring = columnAt<CommandLanes<S>, S>(block, a.on_the_way) + j * kCommandPlaces;
  const long step = static_cast<long>(t / dt + 0.5);
  ring[step % kCommandPlaces] = command;
  return ring[(step + kCommandPlaces - a.delay_steps) % kCommandPlaces];
}

/// Gains of the servo, position within the joint's range; where it is to move slowly, on the way from the one held.
template <class S>
inline CommandLanes<S> ownDemand(const CommandLanes<S>& command, S held, S lower, S upper, S kp, S kd, S dt) {
  const auto on = command.kp > S(0);
  const S wanted = clamp(command.position, lower, upper);
  const S way = wanted - held, limit = command.velocity * dt;
  const auto slow = (command.velocity > S(0)) & (abs(way) > limit);
  const S reached = select(slow, held + withSignOf(limit, way), wanted);
  return {select(on, reached, held), S(0), command.torque, select(on, kp, S(0)), select(on, kd, S(0))};
}

/// The command as it is, with the velocity's share of the torque.
template <class S>
inline CommandLanes<S> commandedDemand(const CommandLanes<S>& command) {
  const S kp = max(command.kp, S(0)), kd = max(command.kd, S(0));
  return {command.position, S(0), fma(kd, command.velocity, command.torque), kp, kd};
}

template <class S>
void controlServos(const ServoControllerArguments& a, const BlockMemory& block, const StepTime& time) {
  auto* demand = columnAt<CommandLanes<S>, S>(block, a.demand);
  const S* q = columnAt<S, S>(block, a.position);
  S* held = columnAt<S, S>(block, a.held);
  const S *lower = columnAt<S, S>(block, a.lower), *upper = columnAt<S, S>(block, a.upper);
  const S *kp = columnAt<S, S>(block, a.kp), *kd = columnAt<S, S>(block, a.kd);
  const S *resolution = columnAt<S, S>(block, a.resolution), zero(0);
  for (int j = 0; j < a.joints; ++j) {
    const CommandLanes<S> command = delayed<S>(a, block, j, time.t, time.dt);
    const S from = select(demand[j].kp > zero, held[j], q[j]);
    demand[j] = a.commanded_gains ? commandedDemand(command)
                                  : ownDemand(command, from, lower[j], upper[j], kp[j], kd[j], S(time.dt));
    held[j] = demand[j].position;
    if (!a.encoder_steps) continue;
    const S seen = select(resolution[j] > zero, resolution[j] * roundToInteger(q[j] / resolution[j]), q[j]);
    demand[j].position = held[j] + (q[j] - seen);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
