#pragma once

/// @file Rotations as orthonormal matrices: R_AB turns the components of a vector from frame B into frame A.
///
/// Angles follow the right hand: rotationX(s, c) turns y towards z. exp and log: [Murray, Li, Sastry 1994, 2.2].

#include "murosimf/math/vec3.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Columns are B's axes seen from A: R_AB = [x_A, y_A, z_A].
template <class S = double>
struct Rotation {
  Vec3<S> x{S(1), S(0), S(0)}, y{S(0), S(1), S(0)}, z{S(0), S(0), S(1)};

  friend Vec3<S> operator*(const Rotation& r, const Vec3<S>& v) {
    return {fma(r.z.x, v.z, fma(r.y.x, v.y, r.x.x * v.x)), fma(r.z.y, v.z, fma(r.y.y, v.y, r.x.y * v.x)),
            fma(r.z.z, v.z, fma(r.y.z, v.y, r.x.z * v.x))};
  }
  friend Rotation operator*(const Rotation& a, const Rotation& b) { return {a * b.x, a * b.y, a * b.z}; }
  friend bool operator==(const Rotation&, const Rotation&) = default;
};

template <class S>
inline Rotation<S> transposed(const Rotation<S>& r) {
  return {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
}
/// R^T v without forming R^T.
template <class S>
inline Vec3<S> applyTransposed(const Rotation<S>& r, const Vec3<S>& v) {
  return {dot(r.x, v), dot(r.y, v), dot(r.z, v)};
}
template <class S>
inline Rotation<S> rotationX(const SinCos<S>& a) {
  return {{S(1), S(0), S(0)}, {S(0), a.cos, a.sin}, {S(0), -a.sin, a.cos}};
}
template <class S>
inline Rotation<S> rotationY(const SinCos<S>& a) {
  return {{a.cos, S(0), -a.sin}, {S(0), S(1), S(0)}, {a.sin, S(0), a.cos}};
}
template <class S>
inline Rotation<S> rotationZ(const SinCos<S>& a) {
  return {{a.cos, a.sin, S(0)}, {-a.sin, a.cos, S(0)}, {S(0), S(0), S(1)}};
}
template <class S>
inline Rotation<S> rotationX(S angle) {
  return rotationX(sincos(angle));
}
template <class S>
inline Rotation<S> rotationY(S angle) {
  return rotationY(sincos(angle));
}
template <class S>
inline Rotation<S> rotationZ(S angle) {
  return rotationZ(sincos(angle));
}
/// Rz(yaw) Ry(pitch) Rx(roll), the convention of URDF.
template <class S>
inline Rotation<S> fromRollPitchYaw(const Vec3<S>& roll_pitch_yaw) {
  return rotationZ(roll_pitch_yaw.z) * (rotationY(roll_pitch_yaw.y) * rotationX(roll_pitch_yaw.x));
}
/// Roll, pitch and yaw [rad] of R = Rz Ry Rx; pitch in [-pi/2, pi/2].
template <class S>
inline Vec3<S> toRollPitchYaw(const Rotation<S>& r) {
  return {atan2(r.y.z, r.z.z), asin(-r.x.z), atan2(r.x.y, r.x.x)};
}
/// Turn by |w| [rad] about the direction of w (Rodrigues' formula).
template <class S>
inline Rotation<S> rotationExp(const Vec3<S>& w) {
  const S angle = norm(w);
  const auto tiny = angle < S(1e-9);
  const Vec3<S> k = w * (S(1) / select(tiny, S(1), angle));
  const SinCos<S> a = sincos(angle);
  const S one_minus_cos = S(1) - a.cos;
  const Vec3<S> ks = select(tiny, w, k * a.sin), kc = select(tiny, Vec3<S>{S(0), S(0), S(0)}, k * one_minus_cos);
  return {{fma(kc.x, k.x, a.cos), fma(kc.x, k.y, ks.z), fma(kc.x, k.z, -ks.y)},
          {fma(kc.y, k.x, -ks.z), fma(kc.y, k.y, a.cos), fma(kc.y, k.z, ks.x)},
          {fma(kc.z, k.x, ks.y), fma(kc.z, k.y, -ks.x), fma(kc.z, k.z, a.cos)}};
}
/// The w with rotationExp(w) = R, |w| < pi (at pi the axis is not recovered: the result is then inaccurate).
template <class S>
inline Vec3<S> rotationLog(const Rotation<S>& r) {
  const Vec3<S> twice_sin{r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x};
  const S s = S(0.5) * norm(twice_sin);
  const S c = S(0.5) * (r.x.x + r.y.y + r.z.z - S(1));
  const auto tiny = s < S(1e-9);
  const S factor = select(tiny, S(1), atan2(s, c) / select(tiny, S(1), s));
  return twice_sin * (S(0.5) * factor);
}
/// The rotation that u of the way from a to b has been turned, on the shortest path.
template <class S>
inline Rotation<S> interpolate(const Rotation<S>& a, const Rotation<S>& b, S u) {
  return a * rotationExp(rotationLog(transposed(a) * b) * u);
}
/// The nearest right-handed orthonormal axes with the same z direction: keeps rounding from growing.
template <class S>
inline Rotation<S> orthonormalized(const Rotation<S>& r) {
  const Vec3<S> z = normalized(r.z);
  const Vec3<S> x = normalized(r.x - z * dot(r.x, z));
  return {x, cross(z, x), z};
}
template <class S>
inline Rotation<S> select(decltype(S() < S()) mask, const Rotation<S>& a, const Rotation<S>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

using Rotation3 = Rotation<double>;

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
