#include "player/vision/lens.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {
namespace {

/// How far out a ray at distance r arrives, and how that grows with r.
struct Reach {
  double value = 0, growth = 1;
};

Reach polynomialReach(const double* kc, double r) {
  const double r2 = r * r;
  const double above = 1 + r2 * (kc[0] + r2 * (kc[1] + r2 * kc[4])),
               below = 1 + r2 * (kc[5] + r2 * (kc[6] + r2 * kc[7]));
  const double above_growth = 2 * r * (kc[0] + r2 * (2 * kc[1] + r2 * 3 * kc[4]));
  const double below_growth = 2 * r * (kc[5] + r2 * (2 * kc[6] + r2 * 3 * kc[7]));
  const double factor = above / below;
  return {r * factor, factor + r * (above_growth - factor * below_growth) / below};
}

Reach angularReach(const double* kc, double r) {
  const double t = atan2(r, 1.0), t2 = t * t;
  const double value = t * (1 + t2 * (kc[0] + t2 * (kc[1] + t2 * (kc[2] + t2 * kc[3]))));
  const double growth = 1 + t2 * (3 * kc[0] + t2 * (5 * kc[1] + t2 * (7 * kc[2] + t2 * 9 * kc[3])));
  return {value, growth / (1 + r * r)};
}

/// Of the radial part, continued.
Reach reach(const client::CameraDescription& camera, double r) {
  const double within = std::min(r, camera.linear_from);
  Reach out =
      camera.lens == client::LensKind::kFisheye ? angularReach(camera.kc, within) : polynomialReach(camera.kc, within);
  out.value += out.growth * (r - within);
  return out;
}

/// first r^2 + second r^4, continued.
Reach prism(const client::CameraDescription& camera, double first, double second, double r) {
  const double within = std::min(r, camera.linear_from), w2 = within * within;
  const double growth = 2 * within * (first + 2 * w2 * second);
  return {w2 * (first + w2 * second) + growth * (r - within), growth};
}

/// Adds what p1, p2 and the prism shift a place by. `square` is r^2, continued.
void addShift(const client::CameraDescription& camera, const PlanePoint& e, double r, DistortedPoint& d) {
  const double* kc = camera.kc;
  const Reach square = prism(camera, 1, 0, r);
  const double ta = 2 * kc[2] * e.a * e.b + kc[3] * (1 + 2 * e.a * e.a);  // at r = 1 in the direction e
  const double tb = kc[2] * (1 + 2 * e.b * e.b) + 2 * kc[3] * e.a * e.b;
  const Reach sa = prism(camera, kc[8], kc[9], r), sb = prism(camera, kc[10], kc[11], r);
  d.point.a += ta * square.value + sa.value;
  d.point.b += tb * square.value + sb.value;
  // Along e by the growth, across it by the turning of e: d(ta, tb) by the angle of e.
  const double ta_turn = 2 * kc[2] * (e.a * e.a - e.b * e.b) - 4 * kc[3] * e.a * e.b;
  const double tb_turn = 4 * kc[2] * e.a * e.b + 2 * kc[3] * (e.a * e.a - e.b * e.b);
  const double a_along = ta * square.growth + sa.growth, a_across = ta_turn * square.value / r;
  const double b_along = tb * square.growth + sb.growth, b_across = tb_turn * square.value / r;
  d.da_da += a_along * e.a - a_across * e.b, d.da_db += a_along * e.b + a_across * e.a;
  d.db_da += b_along * e.a - b_across * e.b, d.db_db += b_along * e.b + b_across * e.a;
}

/// Where the search for a ray begins: the radius alone, by Newton's method with a bound on its steps.
double radiusOf(const client::CameraDescription& camera, double distorted) {
  double r = camera.lens == client::LensKind::kFisheye ? tan(std::min(distorted, 1.5)) : std::min(distorted, 1.0);
  for (int i = 0; i < 60; ++i) {
    const Reach at = reach(camera, r);
    const double error = distorted - at.value;
    if (!(at.growth > 1e-6) || abs(error) < 1e-9) break;  // at the edge of the lens, or there
    r += std::clamp(error / at.growth, -0.5 * r, 0.2 + 0.2 * r);
  }
  return r;
}

}  // namespace

DistortedPoint distort(const client::CameraDescription& camera, const PlanePoint& p) {
  const double r = sqrt(p.a * p.a + p.b * p.b);
  if (r < 1e-9) return {p};  // here every lens is a pinhole
  const PlanePoint e{p.a / r, p.b / r};
  const Reach radial = reach(camera, r);
  const double across = radial.value / r, along = radial.growth;
  DistortedPoint d;
  d.point = {e.a * radial.value, e.b * radial.value};
  d.da_da = along * e.a * e.a + across * e.b * e.b, d.db_db = along * e.b * e.b + across * e.a * e.a;
  d.da_db = d.db_da = (along - across) * e.a * e.b;
  if (camera.lens != client::LensKind::kFisheye) addShift(camera, e, r, d);
  return d;
}

PixelPoint toPixel(const client::CameraDescription& camera, const PlanePoint& p) {
  const PlanePoint d = distort(camera, p).point;
  return {camera.fx * (d.a + camera.skew * d.b) + camera.cx, camera.fy * d.b + camera.cy};
}

PlanePoint toRay(const client::CameraDescription& camera, const PixelPoint& pixel) {
  const double yd = (pixel.v - camera.cy) / camera.fy;
  const double xd = (pixel.u - camera.cx) / camera.fx - camera.skew * yd;
  const double distorted = sqrt(xd * xd + yd * yd), start = radiusOf(camera, distorted);
  PlanePoint p{xd, yd};
  if (distorted > 0) p = {xd * start / distorted, yd * start / distorted};
  for (int i = 0; i < 30; ++i) {
    const DistortedPoint d = distort(camera, p);
    const double error_a = xd - d.point.a, error_b = yd - d.point.b;
    if (d.determinant() < 1e-6) break;  // beyond the edge of the lens: no ray
    const double step_a = (d.db_db * error_a - d.da_db * error_b) / d.determinant();
    const double step_b = (d.da_da * error_b - d.db_da * error_a) / d.determinant();
    const double size = sqrt(step_a * step_a + step_b * step_b), limit = 0.5 * (0.1 + start);
    const double share = size > limit ? limit / size : 1;
    p = {p.a + share * step_a, p.b + share * step_b};
    if (size < 1e-13 * (1 + start)) break;
  }
  return p;
}

}  // namespace murosimf::controllers
