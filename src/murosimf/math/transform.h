#pragma once

/// @file Rigid transforms: X_AB holds the pose of frame B in frame A. p_A = X_AB * p_B.

#include "murosimf/math/rotation.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S = double>
struct Transform {
  Rotation<S> rotation;  ///< R_AB
  Vec3<S> translation;   ///< p_AB_A, B's origin seen from A [m]

  friend Vec3<S> operator*(const Transform& t, const Vec3<S>& p) { return t.rotation * p + t.translation; }
  friend Transform operator*(const Transform& a, const Transform& b) {
    return {a.rotation * b.rotation, a * b.translation};
  }
  friend bool operator==(const Transform&, const Transform&) = default;
};

template <class S>
inline Transform<S> inverse(const Transform<S>& t) {
  return {transposed(t.rotation), -applyTransposed(t.rotation, t.translation)};
}
/// X_AB^-1 * p_A without forming the inverse.
template <class S>
inline Vec3<S> applyInverse(const Transform<S>& t, const Vec3<S>& p) {
  return applyTransposed(t.rotation, p - t.translation);
}
/// The straight path from a to b: positions on a line, turning at constant rate.
template <class S>
inline Transform<S> interpolate(const Transform<S>& a, const Transform<S>& b, S u) {
  return {interpolate(a.rotation, b.rotation, u), interpolate(a.translation, b.translation, u)};
}
template <class S>
inline Transform<S> select(decltype(S() < S()) mask, const Transform<S>& a, const Transform<S>& b) {
  return {select(mask, a.rotation, b.rotation), select(mask, a.translation, b.translation)};
}

using Pose = Transform<double>;

/// Pose in the ground plane: position (x, y) [m] and heading [rad] about z.
struct PlanarPose {
  double x{}, y{}, heading{};
  friend bool operator==(const PlanarPose&, const PlanarPose&) = default;
};
inline Pose toPose(const PlanarPose& p, double height = 0) { return {rotationZ(p.heading), {p.x, p.y, height}}; }

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
