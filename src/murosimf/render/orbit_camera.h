#pragma once

/// @file The camera of a person: it looks at a place, from a direction and a distance, and never from below the ground.

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/math/transform.h"

namespace murosimf {

class OrbitCamera {
 public:
  Vector3 target_W{0, 0, 0.2};
  double distance = 6;     ///< from there [m]
  double azimuth = -1.57;  ///< of the camera, seen from the target, about z from x [rad]
  double elevation = 0.6;  ///< above the horizon [rad]
  double angle = 0.9;      ///< between left and right edge [rad]

  /// X_WC: x right, y down, z forward.
  Pose pose() const;
  /// A lens of this size without distortion.
  CameraModel model(int width, int height) const;

  /// Turns about the target [rad].
  void turn(double sideways, double upwards);
  /// Moves camera and target alike so that what lies at the target's distance follows the mouse [shares of the
  /// picture's width].
  void pan(double right, double down);
  /// Comes nearer (factor < 1) or goes away.
  void zoom(double factor);
};

/// The direction in W in which a pixel is seen, not of unit length: 1 along the optical axis.
Vector3 rayOf(const CameraModel& camera, const Pose& X_WC, ImagePoint place);

}  // namespace murosimf
