#pragma once

/// @file The lens of a camera: which ray of light falls on which pixel.
///
/// For a point p_C = (X, Y, Z) seen from camera frame C, whose x points right, y down, z forward:
///   x = X / Z, y = Y / Z                                    slopes of the ray, r^2 = x^2 + y^2 = s
///   xd = x L(s) + 2 p1 x y + p2 (s + 2 x^2) + s1 s + s2 s^2
///   yd = y L(s) + p1 (s + 2 y^2) + 2 p2 x y + s3 s + s4 s^2
///   u = fx (xd + skew yd) + cx,  v = fy yd + cy             column and row [px]; pixel centres are at integers
/// with the radial factor L of one of two kinds:
///   rational  L = (1 + k1 s + k2 s^2 + k3 s^3) / (1 + k4 s + k5 s^2 + k6 s^3),
///             kc = (k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4): OpenCV's order; k4 to s4 are zero in the model
///             of Bouguet's toolbox, the "plumb bob"
///   fisheye   L = theta_d / r, theta = atan2(r, 1), theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6
///             + k4 theta^8), kc = (k1, k2, k3, k4) and no p, no s
/// [Brown 1971; Heikkila & Silven 1997; Bouguet 2004; Kannala & Brandt 2006; OpenCV 4.6, calib3d]
///
/// The curve r L(r) of a lens may stop growing: from there on no ray belongs to a pixel. A picture that reaches beyond
/// it is refused, or the curve is continued linearly. Rays are slopes, so none stands farther than kLargestAngle from
/// the axis.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "murosimf/math/vec3.h"

namespace murosimf {

/// A place in the picture [px]: column u to the right, row v downwards. (0, 0) is the centre of the first pixel.
struct ImagePoint {
  double u{}, v{};
};

/// A ray by its slopes: it runs along (x, y, 1) in C.
struct RaySlopes {
  double x{}, y{};
};

/// Derivative of the distorted by the undistorted slopes.
struct DistortionJacobian {
  double xx{}, xy{}, yx{}, yy{};  ///< d xd/d x, d xd/d y, d yd/d x, d yd/d y
};

enum class LensKind : std::uint8_t { kRational, kFisheye };

/// Rays stand at most so far from the axis [rad]: 89 deg, where slopes are 57.
inline constexpr double kLargestAngle = 89.0 / 180.0 * kPi;

struct CameraModel {
  int width = 640, height = 480;                                 ///< [px]
  double fx = 500.0, fy = 500.0;                                 ///< focal lengths [px]
  double cx = 319.5, cy = 239.5;                                 ///< where the optical axis meets the picture [px]
  double skew = 0.0;                                             ///< alpha_c
  LensKind kind = LensKind::kRational;                           ///< what kc means
  std::array<double, 12> kc{};                                   ///< numbers of the lens, see above
  double linear_from = std::numeric_limits<double>::infinity();  ///< slope r beyond which the lens goes on as a line
  friend bool operator==(const CameraModel&, const CameraModel&) = default;
};

/// A camera without distortion that sees `horizontal_angle` [rad] between the outer edges of its left- and rightmost
/// pixels; square pixels, axis through the middle of the picture. fx = width / (2 tan(angle / 2)).
/// @throws std::invalid_argument unless 0 < angle < pi, the size is positive, and no ray passes kLargestAngle.
CameraModel makePinholeCamera(int width, int height, double horizontal_angle);

/// Slopes after the lens (xd, yd), and their derivative.
RaySlopes distort(const CameraModel& camera, RaySlopes ray);
DistortionJacobian distortionJacobian(const CameraModel& camera, RaySlopes ray);

/// The pixel that a ray falls on. Right for rays within validRadius(); beyond it the picture would fold over.
ImagePoint project(const CameraModel& camera, RaySlopes ray);

/// Where a point is seen; nothing when it lies behind the camera or beyond what the lens can see. The place may lie
/// outside the picture: ask isInPicture().
std::optional<ImagePoint> projectPoint(const CameraModel& camera, const Vector3& p_C);
/// The same for many points: valid_radius is what validRadius() says of this camera.
std::optional<ImagePoint> projectPoint(const CameraModel& camera, const Vector3& p_C, double valid_radius);
bool isInPicture(const CameraModel& camera, ImagePoint place);

/// The ray that falls on a place of the picture: project() backwards, by Newton's method, to a residual of some 1e-16.
/// @throws std::invalid_argument, naming the angle, when no ray falls there.
RaySlopes unproject(const CameraModel& camera, ImagePoint place);
/// The same for many places: valid_radius is what validRadius() says of this camera.
RaySlopes unproject(const CameraModel& camera, ImagePoint place, double valid_radius);

/// Smallest slope r at which r L(r) stops growing; infinity when it never does, as when it is continued.
double validRadius(const CameraModel& camera);

/// Lets the lens go on as a line in r from where its steepness falls below `least_slope` (of 1 on the axis; a fisheye's
/// by its angle theta), of a fisheye from 80 deg at the latest, so that every pixel has a ray: r L(r) and what p and s
/// add, each along its tangent. The picture is then wrong beyond that angle, but never black.
/// @returns the angle from the axis [rad] from which the lens is not the one described; nothing if it need not change.
std::optional<double> continueLinearly(CameraModel& camera, double least_slope = 0.2);

/// Refuses cameras that cannot be.
/// @throws std::invalid_argument for sizes and focal lengths that are not positive, numbers that are not finite, and a
///   picture that reaches beyond what the lens can see; names the pixel and the largest angle from the axis.
void checkCamera(const CameraModel& camera);

}  // namespace murosimf
