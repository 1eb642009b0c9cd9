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

/// With kp = 0 it is to stay at q. `fastest` is the servo's no-load speed; a smaller positive speed of the command
/// holds instead.
template <class S>
inline JointGoal<S> jointGoal(const CommandLanes<S>& command, S q, S lower, S upper, S fastest) {
  const S zero(0);
  return {clamp(select(command.kp > zero, command.position, q), lower, upper),
          select(command.velocity > zero, min(command.velocity, fastest), fastest)};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
