#pragma once

/// @file The forward kick as key frames, for either foot.
///
/// From the walk-ready pose: shift the weight over the standing foot, lift and swing back, kick, hold, come back, put
/// down, walk-ready; 2.585 s, the foot meets a ball .17 m before the hips about .95 s after the start. The angles were
/// found by search in a multibody simulation of the robot and rounded. The frames are written for the right foot; the
/// left foot's are their mirror image: sides swapped, yaw and roll negated.

#include <vector>

#include "key_frame_player.h"
#include "murosimf/math/vec3.h"

namespace murosimf::controllers {

/// @param foot  kRight or kLeft: the foot that kicks
/// @param walk_ready  posture to end in
std::vector<KeyFrame> kickFrames(int foot, const JointAngles& walk_ready);

/// Balance on the standing leg from the gyroscope, for robots whose soles can tip. Adds to the angles.
/// @param angular_velocity  of the pelvis in its own axes [rad/s], unfiltered
void addKickFeedback(int foot, const Vector3& angular_velocity, JointAngles& angles);

/// Where the ball's centre should be for the kick, in the robot's ground frame R: x, and the distance from the x axis
/// to the kicking foot's side [m]; and where it may be.
struct KickZone {
  double x = 0.17, lowest_x = 0.13, highest_x = 0.21;
  double y = 0.053, lowest_y = 0.03, highest_y = 0.10;
};

/// From the start of the motion until the foot meets the ball, at the latest; and the whole motion [s].
inline constexpr double kKickContactTime = 1.05, kKickTime = 2.585;

/// The ball leaves this much to the kicking foot's side of straight ahead [rad].
inline constexpr double kKickDeviation = degrees(2);

}  // namespace murosimf::controllers
