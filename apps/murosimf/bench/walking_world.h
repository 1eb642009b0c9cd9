#pragma once

/// @file The world of walking_robots.h: where robots stand, and how the scenario of one becomes that of many.

#include "murosimf/bench/walking_robots.h"

namespace murosimf {

/// Null where the machine lacks what was asked for.
/// @throws std::runtime_error with what the reader or the builder says
std::unique_ptr<Simulation> buildWalkingWorld(const RecordedWalk& walk, const WalkingSettings& settings, int robots);

/// Steps by which robot number `robot` lags behind the recording: spread over a stride.
long delayOf(const RecordedWalk& walk, int robot);

}  // namespace murosimf
