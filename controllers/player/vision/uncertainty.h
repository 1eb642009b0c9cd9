#pragma once

/// @file How far measured distances may be off, and the weighing of two of them.

#include "murosimf/math/elementary.h"

namespace murosimf::controllers {

struct Estimate {
  double value = 0, deviation = 1;
};

/// Deviation of the horizontal distance d of a point seen at height h below the camera: d = h tan(angle from below),
/// hence (d^2 + h^2) / h per radian. The inclination is off by the joints' play and the sole's tilt, .7 degrees, and
/// half a pixel of 1 / f.
inline double groundDeviation(double distance, double height, double focal_length) {
  const double inclination = 0.012 + 0.5 / focal_length;
  return (distance * distance + height * height) / (height > 0.05 ? height : 0.05) * inclination;
}

/// Whether two measurements may be of the same thing: three deviations apart at most, and a little for models.
inline bool agree(const Estimate& a, const Estimate& b) {
  return abs(a.value - b.value) < 0.05 + 3 * sqrt(a.deviation * a.deviation + b.deviation * b.deviation);
}

/// Minimum variance estimate of two independent measurements.
inline Estimate fuse(const Estimate& a, const Estimate& b) {
  const double wa = 1 / (a.deviation * a.deviation), wb = 1 / (b.deviation * b.deviation);
  return {(wa * a.value + wb * b.value) / (wa + wb), 1 / sqrt(wa + wb)};
}

}  // namespace murosimf::controllers
