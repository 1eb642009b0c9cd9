#pragma once

/// @file From what cameras of level "oracle" tell to percepts.

#include "murosimf/control/client/robot_frames.h"
#include "percepts.h"
#include "posture.h"

namespace murosimf::controllers {

/// Adds the frame's sights to `out`, put into the robot's ground frame R by the cameras' poses X_RC. They are trusted
/// as those of a good vision are: the player does not know how wrong the oracle is. Lines become points, one every .3
/// m.
void addSights(std::span<const client::CameraSights> sights, const Posture& posture, Percepts& out);

}  // namespace murosimf::controllers
