#pragma once

/// @file The lens of a camera, both ways: from a ray to its pixel, and back by Newton's iteration.
///
/// A ray (a, b, 1) in the camera frame C (x right, y down, z forward) becomes with r2 = a^2 + b^2
///   xd = a L + 2 p1 a b + p2 (r2 + 2 a^2) + s1 r2 + s2 r2^2
///   yd = b L + p1 (r2 + 2 b^2) + 2 p2 a b + s3 r2 + s4 r2^2
///   u  = fx (xd + skew yd) + cx,   v = fy yd + cy,   pixel centres at integers,
/// where L is (1 + k1 r2 + k2 r2^2 + k3 r2^3) / (1 + k4 r2 + k5 r2^2 + k6 r2^3) with kc = k1 k2 p1 p2 k3 k4 k5 k6
/// s1 s2 s3 s4, or of a fisheye theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8) / r, theta = atan r,
/// with kc = k1 k2 k3 k4 and no p, no s. Beyond linear_from all parts go on along their tangents in r.
/// [Bouguet, Camera Calibration Toolbox; Brown 1966; Kannala & Brandt 2006]

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
  double da_da = 1, da_db = 0, db_da = 0, db_db = 1;  ///< d xd / d a, d xd / d b, d yd / d a, d yd / d b
  double determinant() const { return da_da * db_db - da_db * db_da; }
};

DistortedPoint distort(const client::CameraDescription& camera, const PlanePoint& p);

/// The pixel that shows the ray (p.a, p.b, 1).
PixelPoint toPixel(const client::CameraDescription& camera, const PlanePoint& p);

/// The ray (a, b, 1) that the pixel shows. The inverse has no closed form; Newton's method with the exact Jacobian
/// needs four or five steps where the lens is monotone. Beyond the edge of the lens, some ray near it.
PlanePoint toRay(const client::CameraDescription& camera, const PixelPoint& pixel);

}  // namespace murosimf::controllers
