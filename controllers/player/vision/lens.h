#pragma once

/// @file The lens of a camera, both ways: from a ray to its pixel, and back by Newton's iteration.
///
/// A ray (a, b, 1) in the camera frame C (x right, y down, z forward) becomes with r2 = a^2 + b^2
///   L  = 1 + k1 r2 + k2 r2^2 + k3 r2^3
///   xd = a L + 2 p1 a b + p2 (r2 + 2 a^2),   yd = b L + p1 (r2 + 2 b^2) + 2 p2 a b
///   u  = fx (xd + skew yd) + cx,             v  = fy yd + cy,         kc = k1 k2 p1 p2 k3,
/// pixel centres at integers. The inverse has no closed form; Newton's method with the exact Jacobian needs at most
/// four or five steps where the lens is monotone. [Bouguet, Camera Calibration Toolbox; Brown 1966]

#include "murosimf/control/client/robot_description.h"

namespace murosimf::controllers {

/// Where a ray (a, b, 1) cuts the plane one unit in front of the camera.
struct PlanePoint {
  double a = 0, b = 0;
};
/// A place in a picture [pixels]; whole numbers are centres.
struct PixelPoint {
  double u = 0, v = 0;
};

/// The distorted place of an ideal one, and with it the derivatives that Newton's method needs.
struct DistortedPoint {
  PlanePoint point;
  double da_da = 1, da_db = 0, db_db = 1;  ///< the Jacobian is symmetric
};

inline DistortedPoint distort(const double (&kc)[5], const PlanePoint& p) {
  const double r2 = p.a * p.a + p.b * p.b;
  const double radial = 1 + r2 * (kc[0] + r2 * (kc[1] + r2 * kc[4]));
  const double slope = 2 * kc[0] + r2 * (4 * kc[1] + r2 * 6 * kc[4]);  // d radial / d r2, times 2
  const double p1 = kc[2], p2 = kc[3], ab = p.a * p.b;
  DistortedPoint d;
  d.point.a = p.a * radial + 2 * p1 * ab + p2 * (r2 + 2 * p.a * p.a);
  d.point.b = p.b * radial + p1 * (r2 + 2 * p.b * p.b) + 2 * p2 * ab;
  d.da_da = radial + slope * p.a * p.a + 2 * p1 * p.b + 6 * p2 * p.a;
  d.da_db = slope * ab + 2 * p1 * p.a + 2 * p2 * p.b;
  d.db_db = radial + slope * p.b * p.b + 6 * p1 * p.b + 2 * p2 * p.a;
  return d;
}

/// The pixel that shows the ray (p.a, p.b, 1).
inline PixelPoint toPixel(const client::CameraDescription& camera, const PlanePoint& p) {
  const PlanePoint d = distort(camera.kc, p).point;
  return {camera.fx * (d.a + camera.skew * d.b) + camera.cx, camera.fy * d.b + camera.cy};
}

/// The ray (a, b, 1) that the pixel shows. Steps are limited to .5, so that a start far out cannot run away.
inline PlanePoint toRay(const client::CameraDescription& camera, const PixelPoint& pixel) {
  const double yd = (pixel.v - camera.cy) / camera.fy;
  const double xd = (pixel.u - camera.cx) / camera.fx - camera.skew * yd;
  PlanePoint p{xd, yd};
  for (int i = 0; i < 30; ++i) {
    const DistortedPoint d = distort(camera.kc, p);
    const double error_a = xd - d.point.a, error_b = yd - d.point.b;
    const double determinant = d.da_da * d.db_db - d.da_db * d.da_db;
    if (determinant < 1e-6) break;  // beyond the edge of the lens: no ray
    const double step_a = (d.db_db * error_a - d.da_db * error_b) / determinant;
    const double step_b = (d.da_da * error_b - d.da_db * error_a) / determinant;
    const double size = sqrt(step_a * step_a + step_b * step_b);
    const double share = size > 0.5 ? 0.5 / size : 1;
    p = {p.a + share * step_a, p.b + share * step_b};
    if (size < 1e-13) break;
  }
  return p;
}

}  // namespace murosimf::controllers
