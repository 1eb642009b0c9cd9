#pragma once

/// @file What a command asks of a joint whose servo follows it whatever the load.

#include "murosimf/math/pack.h"
#include "murosimf/modules/actuation/command_lanes.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Where the joint is to go, within its range [rad], and how fast it may [rad/s].
template <class S>
struct JointGoal {
  S position, speed;
};

/// With kp = 0 it is to stay at q, unless it hasRate(). `fastest` is the servo's no-load speed; a smaller positive
/// speed of the command holds instead.
template <class S>
inline JointGoal<S> jointGoal(const CommandLanes<S>& command, S q, S lower, S upper, S fastest) {
  const S zero(0);
  return {clamp(select(command.kp > zero, command.position, q), lower, upper),
          select(command.velocity > zero, min(command.velocity, fastest), fastest)};
}

/// Joints that are to turn at a rate, whatever their position, as wheels do: kp = 0 and kd > 0.
template <class S>
inline auto hasRate(const CommandLanes<S>& command) {
  return (command.kp <= S(0)) & (command.kd > S(0));
}
/// That rate: the command's velocity, no faster than `fastest`, and not beyond the joint's range within a step.
template <class S>
inline S wantedRate(const CommandLanes<S>& command, S q, S lower, S upper, S fastest, S per_step) {
  return clamp(clamp(command.velocity, -fastest, fastest), (lower - q) * per_step, (upper - q) * per_step);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
