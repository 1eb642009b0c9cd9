#pragma once

/// @file The pose of a floating base as six numbers, for methods that add up rates of change.
///
/// Rotations cannot be added. Within one step the base's rotation is R = R_0 exp(phi), and phi can:
///     dphi/dt = w + phi x w / 2 + c phi x (phi x w),   c = (1 - (a/2) cot(a/2)) / a^2,   a = |phi|
/// with w in the base's axes [Munthe-Kaas 1999]; so methods of any order keep it on rotations. The position is that of
/// the base's origin in the world, dp/dt = R v.

#include "murosimf/algorithms/gravity.h"
#include "murosimf/math/spatial.h"
#include "murosimf/math/transform.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// A pose's difference from the one at the beginning of the step, or a rate of it.
template <class S = double>
struct BaseChange {
  Vec3<S> phi, p;

  BaseChange& operator+=(const BaseChange& b) { return phi += b.phi, p += b.p, *this; }
  friend BaseChange operator*(const BaseChange& a, S s) { return {a.phi * s, a.p * s}; }
};

/// c of the equation above: 1/12 + a^2/720 + a^4/30240 + ... , exact to rounding for |phi| < 0.3.
template <class S>
inline S turningCoefficient(S square) {
  const S high = fma(square, fma(square, S(1.0 / 47900160), S(1.0 / 1209600)), S(1.0 / 30240));
  return fma(square, fma(square, high, S(1.0 / 720)), S(1.0 / 12));
}

/// The rate of `change` while the base moves with V (its own axes) and has the rotation R.
template <class S>
inline BaseChange<S> rateOf(const BaseChange<S>& change, const Rotation<S>& R, const SpatialMotion<S>& V) {
  const Vec3<S> once = cross(change.phi, V.w), twice = cross(change.phi, once);
  return {V.w + once * S(0.5) + twice * turningCoefficient(squaredNorm(change.phi)), R * V.v};
}

/// The rate of the base's velocity in its own axes, from its proper acceleration: what an accelerometer feels less
/// what gravity, g = 9.81 m/s^2 against `up`, makes it feel.
template <class S>
inline SpatialMotion<S> trueAcceleration(const SpatialMotion<S>& proper, const Vec3<S>& up) {
  return {proper.w, proper.v - up * S(kGravity)};
}

template <class S>
inline Transform<S> changed(const Transform<S>& X, const BaseChange<S>& change) {
  return {X.rotation * rotationExp(change.phi), X.translation + change.p};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
