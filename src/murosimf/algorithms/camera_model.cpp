#include "murosimf/algorithms/camera_model.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace murosimf {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kWorstResidual = 1e-13;  ///< of Newton's method, in slopes; times a focal length of 10 000 px: 1e-9 px

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

/// L and dL / d(r^2).
struct RadialFactor {
  double value, derivative;
};

/// r L(r) of the polynomial and its slope.
double polynomialRadius(const CameraModel& camera, double r) {
  const auto& kc = camera.kc;
  const double s = r * r;
  return r * (1.0 + s * (kc[0] + s * (kc[1] + s * kc[4])));
}
double polynomialSlope(const CameraModel& camera, double s) {
  const auto& kc = camera.kc;
  return 1.0 + s * (3.0 * kc[0] + s * (5.0 * kc[1] + s * 7.0 * kc[4]));
}

// Within linear_from the polynomial; beyond it r L(r) is the tangent there, so L = rest / r + slope.
RadialFactor radialFactor(const CameraModel& camera, double s) {
  const auto& kc = camera.kc;
  const double from = camera.linear_from;
  if (s <= from * from)
    return {1.0 + s * (kc[0] + s * (kc[1] + s * kc[4])), kc[0] + s * (2.0 * kc[1] + s * 3.0 * kc[4])};
  const double slope = polynomialSlope(camera, from * from);
  const double rest = polynomialRadius(camera, from) - slope * from;  // r L = rest + slope r
  const double r = std::sqrt(s);
  return {rest / r + slope, -0.5 * rest / (s * r)};
}

/// Smallest r^2 at which the slope of r L(r) has fallen to `least`; infinity when it never does. Between two places
/// where the slope's own derivative vanishes it is monotone, so there a root is found by halving.
double smallestSquareWithSlope(const CameraModel& camera, double least) {
  const double a = 21.0 * camera.kc[4], b = 10.0 * camera.kc[1], c = 3.0 * camera.kc[0];  // of the derivative
  const double discriminant = b * b - 4.0 * a * c;
  double turns[3] = {INFINITY, INFINITY, 1e12};
  if (a == 0.0) {
    if (b != 0.0) turns[0] = -c / b;
  } else if (discriminant > 0.0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    turns[0] = q / a;
    if (q != 0.0) turns[1] = c / q;
  }
  if (turns[1] < turns[0]) std::swap(turns[0], turns[1]);
  double low = 0.0;
  for (const double turn : turns) {
    if (!(turn > low) || turn > turns[2]) continue;
    double high = turn;
    if (polynomialSlope(camera, high) > least) {
      low = high;
      continue;
    }
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) return high;
      (polynomialSlope(camera, middle) > least ? low : high) = middle;
    }
  }
  return INFINITY;
}

RaySlopes difference(RaySlopes a, RaySlopes b) { return {a.x - b.x, a.y - b.y}; }
double length(RaySlopes a) { return std::sqrt(a.x * a.x + a.y * a.y); }

/// What stands in every message about a pixel that the lens cannot see.
std::string beyondLens(const CameraModel& camera, ImagePoint place, RaySlopes distorted) {
  std::string text = "pixel (" + number(place.u) + ", " + number(place.v) + ") lies beyond what the lens can see: ";
  const double largest = validRadius(camera);
  if (std::isinf(largest)) return text + "no ray falls there with these tangential distortions kc[2], kc[3]";
  return text + "it needs a distorted radius of " + number(length(distorted)) + ", expected at most " +
         number(polynomialRadius(camera, largest)) + ", which the lens reaches at " +
         number(atan2(largest, 1.0) / kDegree) +
         " deg from its axis; choose a longer focal length, a smaller picture, other kc, or let the lens be continued "
         "linearly";
}

}  // namespace

CameraModel makePinholeCamera(int width, int height, double horizontal_angle) {
  if (!(horizontal_angle > 0.0 && horizontal_angle < kPi))
    throw std::invalid_argument("horizontal angle of view is " + number(horizontal_angle) +
                                " rad, expected more than 0 and less than pi");
  CameraModel camera;
  camera.width = width, camera.height = height;
  camera.fx = camera.fy = width / (2.0 * tan(0.5 * horizontal_angle));
  camera.cx = 0.5 * (width - 1), camera.cy = 0.5 * (height - 1);
  checkCamera(camera);
  return camera;
}

RaySlopes distort(const CameraModel& camera, RaySlopes ray) {
  const double x = ray.x, y = ray.y, p1 = camera.kc[2], p2 = camera.kc[3];
  const double s = x * x + y * y;
  const double radial = radialFactor(camera, s).value;
  return {x * radial + 2.0 * p1 * x * y + p2 * (s + 2.0 * x * x),
          y * radial + p1 * (s + 2.0 * y * y) + 2.0 * p2 * x * y};
}

DistortionJacobian distortionJacobian(const CameraModel& camera, RaySlopes ray) {
  const double x = ray.x, y = ray.y, p1 = camera.kc[2], p2 = camera.kc[3];
  const RadialFactor radial = radialFactor(camera, x * x + y * y);
  const double cross = 2.0 * (radial.derivative * x * y + p1 * x + p2 * y);
  return {radial.value + 2.0 * radial.derivative * x * x + 2.0 * p1 * y + 6.0 * p2 * x, cross, cross,
          radial.value + 2.0 * radial.derivative * y * y + 6.0 * p1 * y + 2.0 * p2 * x};
}

ImagePoint project(const CameraModel& camera, RaySlopes ray) {
  const RaySlopes d = distort(camera, ray);
  return {camera.fx * (d.x + camera.skew * d.y) + camera.cx, camera.fy * d.y + camera.cy};
}

std::optional<ImagePoint> projectPoint(const CameraModel& camera, const Vector3& p_C) {
  if (!(p_C.z > 0.0)) return std::nullopt;
  const RaySlopes ray{p_C.x / p_C.z, p_C.y / p_C.z};
  if (std::isinf(camera.linear_from) && length(ray) > validRadius(camera)) return std::nullopt;
  return project(camera, ray);
}

bool isInPicture(const CameraModel& camera, ImagePoint place) {
  return place.u >= -0.5 && place.v >= -0.5 && place.u < camera.width - 0.5 && place.v < camera.height - 0.5;
}

RaySlopes unproject(const CameraModel& camera, ImagePoint place) {
  return unproject(camera, place, validRadius(camera));
}

// Newton's method with the analytic Jacobian, from the distorted slopes. For barrel distortion the radial curve is
// concave and steps approach the ray from below; halving guards the rest. It goes on until rounding stops it.
RaySlopes unproject(const CameraModel& camera, ImagePoint place, double valid_radius) {
  RaySlopes distorted;
  distorted.y = (place.v - camera.cy) / camera.fy;
  distorted.x = (place.u - camera.cx) / camera.fx - camera.skew * distorted.y;
  RaySlopes ray = distorted;
  RaySlopes residual = difference(distort(camera, ray), distorted);
  double error = length(residual);
  const double enough = 1e-16 * (1.0 + length(distorted));
  for (int i = 0; i < 50 && error > enough; ++i) {
    const DistortionJacobian j = distortionJacobian(camera, ray);
    const double determinant = j.xx * j.yy - j.xy * j.yx;
    const RaySlopes step{(j.yy * residual.x - j.xy * residual.y) / determinant,
                         (j.xx * residual.y - j.yx * residual.x) / determinant};
    double share = 1.0;  // halved until the step helps
    RaySlopes next, next_residual;
    do {
      next = {ray.x - share * step.x, ray.y - share * step.y};
      next_residual = difference(distort(camera, next), distorted);
      share *= 0.5;
    } while (!(length(next_residual) < error) && share > 0.01);
    if (!(length(next_residual) < error)) break;
    ray = next, residual = next_residual, error = length(residual);
  }
  const DistortionJacobian j = distortionJacobian(camera, ray);
  const bool beyond = std::isinf(camera.linear_from) && length(ray) > valid_radius;
  const bool folded = beyond || j.xx * j.yy - j.xy * j.yx <= 0.0;
  if (!(error < kWorstResidual * (1.0 + length(distorted))) || folded)
    throw std::invalid_argument(beyondLens(camera, place, distorted));
  return ray;
}

double validRadius(const CameraModel& camera) { return std::sqrt(smallestSquareWithSlope(camera, 0.0)); }

std::optional<double> continueLinearly(CameraModel& camera, double least_slope) {
  camera.linear_from = std::sqrt(smallestSquareWithSlope(camera, least_slope));
  if (std::isinf(camera.linear_from)) return std::nullopt;
  return atan2(camera.linear_from, 1.0);
}

void checkCamera(const CameraModel& camera) {
  if (camera.width <= 0 || camera.height <= 0)
    throw std::invalid_argument("picture of " + std::to_string(camera.width) + " x " + std::to_string(camera.height) +
                                " px, expected positive sizes");
  if (!(camera.fx > 0.0 && camera.fy > 0.0) || std::isinf(camera.fx) || std::isinf(camera.fy))
    throw std::invalid_argument("focal lengths are " + number(camera.fx) + " and " + number(camera.fy) +
                                " px, expected positive numbers");
  double sum = camera.cx + camera.cy + camera.skew;
  for (const double k : camera.kc) sum += k;
  if (!std::isfinite(sum)) throw std::invalid_argument("cx, cy, skew and kc must be finite numbers");
  const double limit = validRadius(camera), right = camera.width - 1, bottom = camera.height - 1;
  for (const double v : {0.0, bottom})  // corners first: they lie farthest out
    for (const double u : {0.0, right}) unproject(camera, {u, v}, limit);
  for (int u = 0; u < camera.width; ++u)
    for (const double v : {0.0, bottom}) unproject(camera, {static_cast<double>(u), v}, limit);
  for (int v = 0; v < camera.height; ++v)
    for (const double u : {0.0, right}) unproject(camera, {u, static_cast<double>(v)}, limit);
}

}  // namespace murosimf
