#pragma once

/// @file How the trunk leans, from gyroscope and accelerometer.
///
/// The upward direction in the trunk's axes turns with the trunk, du/dt = u x w, and is drawn towards the direction of
/// the accelerometer's reading, which points up while the robot is not thrown about: `share` of the difference each
/// second, nothing where the reading is not of about the size of g. R_WB = Rz(heading) Ry(pitch) Rx(roll) gives
/// u = (-sin pitch, cos pitch sin roll, cos pitch cos roll).

#include "murosimf/control/client/state_archive.h"
#include "murosimf/math/vec3.h"

namespace murosimf::controllers::trotter {

class Attitude {
 public:
  /// Takes the readings [rad/s, m/s^2] in trunk axes, dt [s] after the last ones.
  void observe(double dt, const Vector3& angular_velocity, const Vector3& specific_force);
  double roll() const;
  double pitch() const;
  /// Cosine of the angle between the trunk's z and the vertical.
  double upright() const { return up_.z; }
  void archive(client::StateArchive& archive) { archive(up_); }

 private:
  Vector3 up_{0, 0, 1};
};

}  // namespace murosimf::controllers::trotter
