#include "murosimf/algorithms/lens_curve.h"

#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/polynomial.h"

namespace murosimf {
namespace {

constexpr double kEnough = 1e-7;         ///< what is left is for one more step of whoever asks
constexpr double kLargestSquare = 1e12;  ///< slopes of a million are as good as infinite

Polynomial numerator(const CameraModel& camera) {
  const auto& k = camera.kc;
  return {k[4] != 0.0 ? 3 : k[1] != 0.0 ? 2 : k[0] != 0.0 ? 1 : 0, {1.0, k[0], k[1], k[4]}};
}
Polynomial denominator(const CameraModel& camera) {
  const auto& k = camera.kc;
  return {k[7] != 0.0 ? 3 : k[6] != 0.0 ? 2 : k[5] != 0.0 ? 1 : 0, {1.0, k[5], k[6], k[7]}};
}
Polynomial timesVariable(const Polynomial& p) { return product({1, {0.0, 1.0}}, p); }

OfSquare rationalFactor(const CameraModel& camera, double s) {
  const auto& k = camera.kc;
  const double n = 1.0 + s * (k[0] + s * (k[1] + s * k[4])), dn = k[0] + s * (2.0 * k[1] + s * 3.0 * k[4]);
  if (k[5] == 0.0 && k[6] == 0.0 && k[7] == 0.0) return {n, dn};
  const double d = 1.0 + s * (k[5] + s * (k[6] + s * k[7])), dd = k[5] + s * (2.0 * k[6] + s * 3.0 * k[7]);
  return {n / d, (dn - n / d * dd) / d};
}

/// theta_d / theta as a polynomial in q = theta^2, and d theta_d / d theta.
double angleFactor(const CameraModel& camera, double q) {
  const auto& k = camera.kc;
  return 1.0 + q * (k[0] + q * (k[1] + q * (k[2] + q * k[3])));
}
Polynomial angleSlope(const CameraModel& camera) {
  const auto& k = camera.kc;
  return {4, {1.0, 3.0 * k[0], 5.0 * k[1], 7.0 * k[2], 9.0 * k[3]}};
}

// d theta / d r = 1 / (1 + s). Near the axis the derivative is a difference of nearly equal numbers: there its series
// stands, from theta = r - r^3 / 3 + r^5 / 5.
OfSquare fisheyeFactor(const CameraModel& camera, double s) {
  const auto& k = camera.kc;
  const double a = k[0] - 1.0 / 3.0, b = 0.2 - k[0] + k[1];
  if (s < 1e-5) return {1.0 + s * (a + s * b), a + 2.0 * s * b};
  const double r = std::sqrt(s), theta = atan2(r, 1.0), q = theta * theta;
  const double value = theta * angleFactor(camera, q) / r;
  return {value, 0.5 * (valueAt(angleSlope(camera), q) / (1.0 + s) - value) / s};
}

OfSquare describedFactor(const CameraModel& camera, double s) {
  return camera.kind == LensKind::kFisheye ? fisheyeFactor(camera, s) : rationalFactor(camera, s);
}

CurvePoint curveOf(const OfSquare& factor, double r) {
  return {r * factor.value, factor.value + 2.0 * r * r * factor.derivative};
}

bool isContinued(const CameraModel& camera, double s) { return s > camera.linear_from * camera.linear_from; }

double firstRadiusOfFisheye(const CameraModel& camera, double least) {
  Polynomial steepness = angleSlope(camera);
  steepness.c[0] -= least;
  const double largest = 0.5 * kPi, theta = std::sqrt(firstFall(steepness, largest * largest));
  return theta < largest ? tan(theta) : INFINITY;
}

}  // namespace

OfSquare radialFactor(const CameraModel& camera, double s) {
  if (!isContinued(camera, s)) return describedFactor(camera, s);
  const double from = camera.linear_from, r = std::sqrt(s);
  const CurvePoint end = curveOf(describedFactor(camera, from * from), from);
  const double rest = end.value - end.slope * from;  // r L = rest + slope r
  return {rest / r + end.slope, -0.5 * rest / (s * r)};
}

OfSquare tangentialFactor(const CameraModel& camera, double s) {
  if (!isContinued(camera, s)) return {1.0, 0.0};
  const double from = camera.linear_from, r = std::sqrt(s);
  return {from * (2.0 * r - from) / s, from * (from - r) / (s * s)};
}

OfSquare thinPrism(const CameraModel& camera, double first, double second, double s) {
  if (!isContinued(camera, s)) return {s * (first + s * second), first + 2.0 * s * second};
  const double from = camera.linear_from, end = from * from, r = std::sqrt(s);
  const double slope = 2.0 * from * (first + 2.0 * end * second);
  return {end * (first + end * second) + slope * (r - from), 0.5 * slope / r};
}

CurvePoint curveAt(const CameraModel& camera, double r) { return curveOf(radialFactor(camera, r * r), r); }

double poleRadius(const CameraModel& camera) {
  if (camera.kind == LensKind::kFisheye) return INFINITY;
  return std::sqrt(firstFall(denominator(camera), kLargestSquare));
}

// With L = N / D: d(r L) / dr = ((N + 2 s N') D - 2 s N D') / D^2.
double firstRadiusOfSteepness(const CameraModel& camera, double least) {
  if (camera.kind == LensKind::kFisheye) return firstRadiusOfFisheye(camera, least);
  const Polynomial n = numerator(camera), d = denominator(camera);
  const Polynomial growing = product(sum(n, timesVariable(derivativeOf(n)), 2.0), d);
  const Polynomial falling = timesVariable(product(n, derivativeOf(d)));
  const Polynomial excess = sum(sum(growing, falling, -2.0), product(d, d), -least);
  const double root = std::sqrt(firstFall(excess, kLargestSquare));
  return root < poleRadius(camera) ? root : INFINITY;
}

double radiusOfCurve(const CameraModel& camera, double value, double limit) {
  double low = 0.0, high = limit;
  double r = camera.kind == LensKind::kFisheye ? tan(std::min(value, 1.5)) : value;
  if (!(r < high)) r = 0.5 * high;
  for (int i = 0; i < 100; ++i) {
    const CurvePoint point = curveAt(camera, r);
    const double excess = point.value - value;
    if (std::fabs(excess) <= kEnough * value) return r;
    (excess < 0.0 ? low : high) = r;
    double next = r - excess / point.slope;
    if (!(next > low && next < high)) next = std::isinf(high) ? 2.0 * r : 0.5 * (low + high);
    if (next == r) return r;
    r = next;
  }
  return r;
}

}  // namespace murosimf
