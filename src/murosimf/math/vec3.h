#pragma once

/// @file Vectors of three numbers, on any scalar S (double, or a pack of double).

#include "murosimf/math/elementary.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S = double>
struct Vec3 {
  S x{}, y{}, z{};

  S& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  const S& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
  Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Vec3& a, S s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(S s, const Vec3& a) { return {a.x * s, a.y * s, a.z * s}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// The component along coordinate axis A.
template <int A, class S>
inline const S& component(const Vec3<S>& v) {
  return A == 0 ? v.x : A == 1 ? v.y : v.z;
}
template <int A, class S>
inline S& component(Vec3<S>& v) {
  return A == 0 ? v.x : A == 1 ? v.y : v.z;
}
template <class S>
inline S dot(const Vec3<S>& a, const Vec3<S>& b) {
  return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x));
}
template <class S>
inline Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) {
  return {fnma(a.z, b.y, a.y * b.z), fnma(a.x, b.z, a.z * b.x), fnma(a.y, b.x, a.x * b.y)};
}
/// a + b s.
template <class S>
inline Vec3<S> plusScaled(const Vec3<S>& a, const Vec3<S>& b, S s) {
  return {fma(b.x, s, a.x), fma(b.y, s, a.y), fma(b.z, s, a.z)};
}
/// a + b x c.
template <class S>
inline Vec3<S> plusCross(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c) {
  return {fnma(b.z, c.y, fma(b.y, c.z, a.x)), fnma(b.x, c.z, fma(b.z, c.x, a.y)), fnma(b.y, c.x, fma(b.x, c.y, a.z))};
}
template <class S>
inline S squaredNorm(const Vec3<S>& a) {
  return dot(a, a);
}
template <class S>
inline S norm(const Vec3<S>& a) {
  return sqrt(squaredNorm(a));
}
/// a / |a|; the zero vector stays zero.
template <class S>
inline Vec3<S> normalized(const Vec3<S>& a) {
  const S length = norm(a);
  return a * (S(1) / select(length > S(0), length, S(1)));
}
template <class S>
inline Vec3<S> select(decltype(S() < S()) mask, const Vec3<S>& a, const Vec3<S>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
/// (1 - u) a + u b.
template <class S>
inline Vec3<S> interpolate(const Vec3<S>& a, const Vec3<S>& b, S u) {
  return {fma(u, b.x - a.x, a.x), fma(u, b.y - a.y, a.y), fma(u, b.z - a.z, a.z)};
}

using Vector3 = Vec3<double>;

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
