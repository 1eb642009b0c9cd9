#pragma once

/// @file What a lens does along a ray from the middle of the picture outwards, for every kind of lens: the functions
/// of s = r^2 of which camera_model.h is made, and where their curve r L(r) ends.
///
/// Beyond camera.linear_from = a, functions go on along their tangents in r: with C = r L and its slope m at a,
///   L = (C(a) - m a) / r + m                of the radial part,
///   g = (2 a r - a^2) / r^2                 a factor on the part of p1, p2, which grows with r^2,
///   P = P(a) + P'(a) (r - a)                of the thin prism.

#include "murosimf/algorithms/camera_model.h"

namespace murosimf {

/// A function of s and its derivative by s.
struct OfSquare {
  double value{}, derivative{};
};

OfSquare radialFactor(const CameraModel& camera, double s);      ///< L
OfSquare tangentialFactor(const CameraModel& camera, double s);  ///< g: 1 within linear_from
/// first s + second s^2
OfSquare thinPrism(const CameraModel& camera, double first, double second, double s);

/// r L(r) and its slope in r.
struct CurvePoint {
  double value{}, slope{};
};
CurvePoint curveAt(const CameraModel& camera, double r);

/// Smallest r at which the steepness of the described curve, without its continuation, has fallen to `least`: of r L(r)
/// in r, or of theta_d in theta. Infinity when it never does, for a rational lens before a pole of L.
double firstRadiusOfSteepness(const CameraModel& camera, double least);
/// Smallest r at which the denominator of L vanishes.
double poleRadius(const CameraModel& camera);

/// The r at which r L(r) has a value, to some 1e-7 of it, by Newton's method within an interval that closes in. Right
/// where the curve grows until `limit` and reaches the value; else somewhere within.
double radiusOfCurve(const CameraModel& camera, double value, double limit);

}  // namespace murosimf
