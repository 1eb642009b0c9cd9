#pragma once

/// @file Whether the robot has fallen, and what it lies on, from the accelerometer of its trunk.
///
/// A body at rest feels the ground push it upwards, so the reading f points up, however the body lies. Tilt is the
/// angle between f and the trunk's z axis. Lying: tilt above 45 deg for .3 s. Upright: below 25 deg for .7 s. Impacts
/// are cut at 4 g in each axis and smoothed (share .3 of each reading, at 100 Hz). Where f is below a third of g, in
/// flight or without an accelerometer, it tells nothing, and nothing is claimed.

#include "murosimf/control/client/state_archive.h"
#include "murosimf/math/vec3.h"

namespace murosimf::controllers {

/// What a lying robot lies on.
enum class LyingSide : std::uint8_t { kFront, kBack, kFlank };

class FallDetector {
 public:
  /// Takes one reading [m/s^2], trunk axes, dt [s] after the last one.
  void observe(double dt, const Vector3& specific_force);
  bool lies() const;
  bool upright() const;
  /// Of a robot that lies, by that of the trunk's axes x and y that is closer to the vertical: x down, x up, or y.
  LyingSide side() const;
  void archive(client::StateArchive& archive) { archive(smoothed_, tilted_time_, upright_time_); }

 private:
  Vector3 smoothed_;         ///< f [m/s^2]
  double tilted_time_ = 0;   ///< without interruption [s]
  double upright_time_ = 0;  ///< [s]
};

}  // namespace murosimf::controllers
