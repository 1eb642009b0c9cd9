#pragma once

/// @file The lens of a camera: which ray of light falls on which pixel.
///
/// Model (Bouguet's toolbox, OpenCV's "plumb bob"), for a point p_C = (X, Y, Z) seen from camera frame C, whose x
/// points right, y down, z forward:
///   x = X / Z, y = Y / Z                                    slopes of the ray, r^2 = x^2 + y^2
///   L = 1 + k1 r^2 + k2 r^4 + k3 r^6                        radial factor
///   xd = x L + 2 p1 x y + p2 (r^2 + 2 x^2)                  kc = (k1, k2, p1, p2, k3): mind the order
///   yd = y L + p1 (r^2 + 2 y^2) + 2 p2 x y
///   u = fx (xd + skew yd) + cx,  v = fy yd + cy             column and row [px]; pixel centres are at integers
/// [Brown 1971; Heikkila & Silven 1997; Bouguet 2004]
///
/// The radius r L(r) of a lens may stop growing: beyond the smallest root of 1 + 3 k1 r^2 + 5 k2 r^4 + 7 k3 r^6 no ray
/// belongs to a pixel. A picture that reaches beyond it is refused, or the radial curve is continued linearly.

#include <array>
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

struct CameraModel {
  int width = 640, height = 480;                                 ///< [px]
  double fx = 500.0, fy = 500.0;                                 ///< focal lengths [px]
  double cx = 319.5, cy = 239.5;                                 ///< where the optical axis meets the picture [px]
  double skew = 0.0;                                             ///< alpha_c
  std::array<double, 5> kc{0, 0, 0, 0, 0};                       ///< k1 k2 p1 p2 k3
  double linear_from = std::numeric_limits<double>::infinity();  ///< slope r beyond which r L(r) goes on as a line
  friend bool operator==(const CameraModel&, const CameraModel&) = default;
};

/// A camera without distortion that sees `horizontal_angle` [rad] between the outer edges of its left- and rightmost
/// pixels; square pixels, axis through the middle of the picture. fx = width / (2 tan(angle / 2)).
/// @throws std::invalid_argument unless 0 < angle < pi and the size is positive.
CameraModel makePinholeCamera(int width, int height, double horizontal_angle);

/// Slopes after the lens (xd, yd), and their derivative.
RaySlopes distort(const CameraModel& camera, RaySlopes ray);
DistortionJacobian distortionJacobian(const CameraModel& camera, RaySlopes ray);

/// The pixel that a ray falls on. Right for rays within validRadius(); beyond it the picture would fold over.
ImagePoint project(const CameraModel& camera, RaySlopes ray);

/// Where a point is seen; nothing when it lies behind the camera or beyond what the lens can see. The place may lie
/// outside the picture: ask isInPicture().
std::optional<ImagePoint> projectPoint(const CameraModel& camera, const Vector3& p_C);
bool isInPicture(const CameraModel& camera, ImagePoint place);

/// The ray that falls on a place of the picture: project() backwards, by Newton's method, to a residual of some 1e-16.
/// @throws std::invalid_argument, naming the angle, when no ray falls there.
RaySlopes unproject(const CameraModel& camera, ImagePoint place);
/// The same for many places: valid_radius is what validRadius() says of this camera.
RaySlopes unproject(const CameraModel& camera, ImagePoint place, double valid_radius);

/// Smallest slope r at which r L(r) stops growing; infinity when it never does.
double validRadius(const CameraModel& camera);

/// Lets the radial curve go on as a line from where its steepness falls below `least_slope` (of 1 on the axis), so that
/// every pixel has a ray. The picture is then wrong beyond that angle, but never black.
/// @returns the angle from the axis [rad] from which the lens is not the one described; nothing if it need not change.
std::optional<double> continueLinearly(CameraModel& camera, double least_slope = 0.2);

/// Refuses cameras that cannot be.
/// @throws std::invalid_argument for sizes and focal lengths that are not positive, numbers that are not finite, and a
///   picture that reaches beyond what the lens can see; names the pixel and the largest angle from the axis.
void checkCamera(const CameraModel& camera);

}  // namespace murosimf
