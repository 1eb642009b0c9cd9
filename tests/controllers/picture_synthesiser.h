#pragma once

/// @file A picture synthesiser for tests of the vision, written for them alone and independent of the simulator.
///
/// One ray a pixel through the lens (inverted by damped fixed-point iteration, not by Newton's method as elsewhere),
/// spheres, upright cylinders and turned boxes on a painted carpet, diffuse light, a gain, and noise. Lines on the
/// ground get soft edges as wide as the pixel's footprint. Slow and plain on purpose.

#include <array>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"

namespace murosimf::test {

using Rgb = std::array<double, 3>;

/// A solid with an upright axis.
struct Solid {
  enum class Kind { kSphere, kCylinder, kBox } kind = Kind::kSphere;
  Vector3 centre;      ///< in W [m]
  double radius = 0;   ///< sphere, cylinder [m]
  Vector3 half;        ///< box: half edges; cylinder: half.z is half of the height [m]
  double heading = 0;  ///< box [rad]
  Rgb colour{};        ///< [0, 255]
  int label = 0;       ///< what firstHit() reports
};

struct SyntheticScene {
  client::FieldDescription field;
  std::vector<Solid> solids;
  double gain = 1, noise = 4;    ///< noise [grey levels]
  double ground_brightness = 1;  ///< of carpet, lines and floor alone
  std::uint64_t seed = 1;
};

inline constexpr int kGroundLabel = -1, kSkyLabel = -2, kBallLabel = 1;

/// The field of 4.5 x 3.0 m with two goals and two landmark poles.
client::FieldDescription smallField();
/// Lines, a yellow goal at +x, a blue one at -x, poles at the halfway line (+y: yellow on top).
SyntheticScene emptyField();
void addBall(SyntheticScene& scene, double x, double y, double height_of_centre = 0.07, double radius = 0.07);
/// A plain kid-size robot of boxes with marks on trunk and arms.
void addRobot(SyntheticScene& scene, const PlanarPose& pose, bool magenta, int label);

/// Label of the first thing on the ray from p_W along d_W. The first parameter's noise and gain do not matter.
int firstHit(const SyntheticScene& scene, const Vector3& p_W, const Vector3& d_W);

class SyntheticCamera {
 public:
  explicit SyntheticCamera(const client::CameraDescription& description);
  /// Renders into `rgb`, which is given its size.
  void render(const SyntheticScene& scene, const Pose& X_WC, std::vector<std::uint8_t>& rgb) const;
  const Vector3& ray(int u, int v) const { return rays_[static_cast<std::size_t>(v * description_.width + u)]; }
  const client::CameraDescription& description() const { return description_; }

 private:
  client::CameraDescription description_;
  std::vector<Vector3> rays_;  ///< (a, b, 1) in C
};

/// The two cameras of KS21: head 640 x 480, pinhole angle 60 degrees; chest 320 x 240, 100 degrees.
client::CameraDescription headCamera();
client::CameraDescription chestCamera();
/// Pose of the camera in R when the robot stands ready, head turned left by pan and down by tilt [rad].
Pose headCameraPose(double pan, double tilt);
Pose chestCameraPose();

}  // namespace murosimf::test
