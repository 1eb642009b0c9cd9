#include "murosimf/algorithms/camera_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "murosimf/algorithms/lens_curve.h"

namespace murosimf {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kWorstResidual = 1e-13;  ///< of Newton's method, in slopes; times a focal length of 10 000 px: 1e-9 px

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

RaySlopes difference(RaySlopes a, RaySlopes b) { return {a.x - b.x, a.y - b.y}; }
double length(RaySlopes a) { return std::sqrt(a.x * a.x + a.y * a.y); }

/// Rays are looked for up to this slope.
double largestSlope(double valid_radius) {
  static const double slope = tan(kLargestAngle);
  return std::min(valid_radius, slope);
}

/// What stands in every message about a pixel that the lens cannot see.
std::string beyondLens(const CameraModel& camera, ImagePoint place, RaySlopes distorted, double valid_radius) {
  const double largest = largestSlope(valid_radius), reached = curveAt(camera, largest).value;
  const std::string text =
      "pixel (" + number(place.u) + ", " + number(place.v) + ") lies beyond what the lens can see: ";
  if (length(distorted) < reached)
    return text + "no ray falls there with these tangential distortions p1, p2, s1 to s4";
  const std::string angle = number(atan2(largest, 1.0) / kDegree);
  return text + "it needs a distorted radius of " + number(length(distorted)) + ", expected at most " +
         number(reached) + ", which the lens reaches at " + angle + " deg from its axis, " +
         (largest < valid_radius ? "the largest angle of a ray" : "where its curve stops growing") +
         "; choose a longer focal length, a smaller picture, other kc, or let the lens be continued linearly";
}

// Newton's method with the analytic Jacobian from a ray nearby; halving guards it. It goes on until rounding stops it.
struct Search {
  RaySlopes ray;
  double error = 0.0;  ///< length of what is left
};
Search newton(const CameraModel& camera, RaySlopes distorted, RaySlopes ray) {
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
  return {ray, error};
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
  const double x = ray.x, y = ray.y, s = x * x + y * y;
  const double radial = radialFactor(camera, s).value;
  if (camera.kind == LensKind::kFisheye) return {x * radial, y * radial};
  const auto& kc = camera.kc;
  const double p1 = kc[2], p2 = kc[3], tangential = tangentialFactor(camera, s).value;
  return {
      x * radial + tangential * (2.0 * p1 * x * y + p2 * (s + 2.0 * x * x)) + thinPrism(camera, kc[8], kc[9], s).value,
      y * radial + tangential * (p1 * (s + 2.0 * y * y) + 2.0 * p2 * x * y) +
          thinPrism(camera, kc[10], kc[11], s).value};
}

DistortionJacobian distortionJacobian(const CameraModel& camera, RaySlopes ray) {
  const double x = ray.x, y = ray.y, s = x * x + y * y;
  const OfSquare radial = radialFactor(camera, s);
  const double cross = 2.0 * radial.derivative * x * y;
  DistortionJacobian j{radial.value + 2.0 * radial.derivative * x * x, cross, cross,
                       radial.value + 2.0 * radial.derivative * y * y};
  if (camera.kind == LensKind::kFisheye) return j;
  const auto& kc = camera.kc;
  const double p1 = kc[2], p2 = kc[3];
  const OfSquare tangential = tangentialFactor(camera, s);
  const double g = tangential.value, tx = 2.0 * p1 * x * y + p2 * (s + 2.0 * x * x),
               ty = p1 * (s + 2.0 * y * y) + 2.0 * p2 * x * y;
  const double dx = 2.0 * (tangential.derivative * tx + thinPrism(camera, kc[8], kc[9], s).derivative);
  const double dy = 2.0 * (tangential.derivative * ty + thinPrism(camera, kc[10], kc[11], s).derivative);
  j.xx += g * (2.0 * p1 * y + 6.0 * p2 * x) + dx * x, j.xy += g * 2.0 * (p1 * x + p2 * y) + dx * y;
  j.yx += g * 2.0 * (p1 * x + p2 * y) + dy * x, j.yy += g * (6.0 * p1 * y + 2.0 * p2 * x) + dy * y;
  return j;
}

ImagePoint project(const CameraModel& camera, RaySlopes ray) {
  const RaySlopes d = distort(camera, ray);
  return {camera.fx * (d.x + camera.skew * d.y) + camera.cx, camera.fy * d.y + camera.cy};
}

std::optional<ImagePoint> projectPoint(const CameraModel& camera, const Vector3& p_C) {
  return projectPoint(camera, p_C, validRadius(camera));
}

std::optional<ImagePoint> projectPoint(const CameraModel& camera, const Vector3& p_C, double valid_radius) {
  if (!(p_C.z > 0.0)) return std::nullopt;
  const RaySlopes ray{p_C.x / p_C.z, p_C.y / p_C.z};
  if (length(ray) > valid_radius) return std::nullopt;
  return project(camera, ray);
}

bool isInPicture(const CameraModel& camera, ImagePoint place) {
  return place.u >= -0.5 && place.v >= -0.5 && place.u < camera.width - 0.5 && place.v < camera.height - 0.5;
}

RaySlopes unproject(const CameraModel& camera, ImagePoint place) {
  return unproject(camera, place, validRadius(camera));
}

// The radius is found first, along the monotone curve of the lens; Newton's method in two dimensions then has but the
// tangential part to find.
RaySlopes unproject(const CameraModel& camera, ImagePoint place, double valid_radius) {
  RaySlopes distorted;
  distorted.y = (place.v - camera.cy) / camera.fy;
  distorted.x = (place.u - camera.cx) / camera.fx - camera.skew * distorted.y;
  const double radius = length(distorted), largest = largestSlope(valid_radius);
  const double share = radius > 0.0 ? radiusOfCurve(camera, radius, largest) / radius : 1.0;
  const Search found = newton(camera, distorted, {share * distorted.x, share * distorted.y});
  const DistortionJacobian j = distortionJacobian(camera, found.ray);
  const bool folded = !(length(found.ray) <= largest) || j.xx * j.yy - j.xy * j.yx <= 0.0;
  if (!(found.error < kWorstResidual * (1.0 + radius)) || folded)
    throw std::invalid_argument(beyondLens(camera, place, distorted, valid_radius));
  return found.ray;
}

double validRadius(const CameraModel& camera) {
  if (!std::isinf(camera.linear_from)) return INFINITY;
  return std::min(firstRadiusOfSteepness(camera, 0.0), poleRadius(camera));
}

std::optional<double> continueLinearly(CameraModel& camera, double least_slope) {
  constexpr double kFromAtLatest = 80.0 * kDegree;  // of a fisheye, whose slopes grow without end
  camera.linear_from = firstRadiusOfSteepness(camera, least_slope);
  if (camera.kind == LensKind::kFisheye) camera.linear_from = std::min(camera.linear_from, tan(kFromAtLatest));
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
