#pragma once

/// @file Velocities that lead the walking robot to a pose, around what stands in the way. All in R.

#include <span>

#include "plane.h"
#include "walking_engine.h"

namespace murosimf::controllers {

/// Walks to the pose: far away it turns towards the place and walks ahead, near it moves in any direction while it
/// takes the wanted heading. `largest` limits the speed [m/s].
WalkCommand walkTo(const PlanarPose& target_R, double largest = 0.25);

/// Turns on the spot to the bearing [rad], at 0.8 rad/s at most.
WalkCommand turnTo(double bearing);

/// The point to head for instead of target_R so that the straight way keeps `clearance` [m] from every obstacle.
/// Obstacles within `ignored` of the target do not count: it is their place that is wanted.
Point detour(const Point& target_R, std::span<const Point> obstacles_R, double clearance, double ignored);

/// The next point on a way to target_R that keeps `radius` [m] from centre_R: the target itself where the straight way
/// does, else a point on the circle. `centre_R` is not between robot and target when the robot is past it.
Point wayAround(const Point& centre_R, double radius, const Point& target_R);

}  // namespace murosimf::controllers
