#pragma once

/// @file Matrices of three by three numbers on any scalar S: symmetric ones and general ones.
///
/// Entries are reached by indices known to the compiler, entry<i, j>(m), so that code for "the axis and the two others"
/// is written once for all three axes and costs nothing.

#include "murosimf/math/rotation.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S = double>
struct Symmetric3 {
  S xx{}, yy{}, zz{}, xy{}, xz{}, yz{};

  MUROSIMF_INLINE Symmetric3& operator+=(const Symmetric3& b) {
    return xx += b.xx, yy += b.yy, zz += b.zz, xy += b.xy, xz += b.xz, yz += b.yz, *this;
  }
  MUROSIMF_INLINE friend Vec3<S> operator*(const Symmetric3& m, const Vec3<S>& v) {
    return {fma(m.xz, v.z, fma(m.xy, v.y, m.xx * v.x)), fma(m.yz, v.z, fma(m.yy, v.y, m.xy * v.x)),
            fma(m.zz, v.z, fma(m.yz, v.y, m.xz * v.x))};
  }
  friend bool operator==(const Symmetric3&, const Symmetric3&) = default;
};

template <class S>
MUROSIMF_INLINE Symmetric3<S> select(decltype(S() < S()) mask, const Symmetric3<S>& a, const Symmetric3<S>& b) {
  return {select(mask, a.xx, b.xx), select(mask, a.yy, b.yy), select(mask, a.zz, b.zz),
          select(mask, a.xy, b.xy), select(mask, a.xz, b.xz), select(mask, a.yz, b.yz)};
}
template <int I, int J, class S>
inline S& entry(Symmetric3<S>& m) {
  static_assert(I >= 0 && I < 3 && J >= 0 && J < 3);
  if constexpr (I == J) return I == 0 ? m.xx : I == 1 ? m.yy : m.zz;
  return I + J == 1 ? m.xy : I + J == 2 ? m.xz : m.yz;
}
template <int I, int J, class S>
inline const S& entry(const Symmetric3<S>& m) {
  return entry<I, J>(const_cast<Symmetric3<S>&>(m));
}

/// Rows of numbers: e[i][j] is in row i and column j.
template <class S = double>
struct Matrix3 {
  S e[3][3]{};

  MUROSIMF_INLINE Matrix3& operator+=(const Matrix3& b) {
    e[0][0] += b.e[0][0], e[0][1] += b.e[0][1], e[0][2] += b.e[0][2];
    e[1][0] += b.e[1][0], e[1][1] += b.e[1][1], e[1][2] += b.e[1][2];
    e[2][0] += b.e[2][0], e[2][1] += b.e[2][1], e[2][2] += b.e[2][2];
    return *this;
  }
  MUROSIMF_INLINE friend Vec3<S> operator*(const Matrix3& m, const Vec3<S>& v) {
    return {fma(m.e[0][2], v.z, fma(m.e[0][1], v.y, m.e[0][0] * v.x)),
            fma(m.e[1][2], v.z, fma(m.e[1][1], v.y, m.e[1][0] * v.x)),
            fma(m.e[2][2], v.z, fma(m.e[2][1], v.y, m.e[2][0] * v.x))};
  }
};

template <class S>
MUROSIMF_INLINE Matrix3<S> select(decltype(S() < S()) mask, const Matrix3<S>& a, const Matrix3<S>& b) {
  Matrix3<S> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.e[i][j] = select(mask, a.e[i][j], b.e[i][j]);
  }
  return result;
}

/// Column J, as a vector.
template <int J, class S>
MUROSIMF_INLINE Vec3<S> column(const Symmetric3<S>& m) {
  return {entry<0, J>(m), entry<1, J>(m), entry<2, J>(m)};
}
template <int J, class S>
MUROSIMF_INLINE Vec3<S> column(const Matrix3<S>& m) {
  return {m.e[0][J], m.e[1][J], m.e[2][J]};
}
/// Row I, as a vector.
template <int I, class S>
MUROSIMF_INLINE Vec3<S> row(const Matrix3<S>& m) {
  return {m.e[I][0], m.e[I][1], m.e[I][2]};
}

/// m - u w^T; for the symmetric matrix, w must be a multiple of u.
template <class S>
MUROSIMF_INLINE Symmetric3<S> lessOuter(const Symmetric3<S>& m, const Vec3<S>& u, const Vec3<S>& w) {
  return {fnma(u.x, w.x, m.xx), fnma(u.y, w.y, m.yy), fnma(u.z, w.z, m.zz),
          fnma(u.x, w.y, m.xy), fnma(u.x, w.z, m.xz), fnma(u.y, w.z, m.yz)};
}
template <class S>
MUROSIMF_INLINE Matrix3<S> lessOuter(const Matrix3<S>& m, const Vec3<S>& u, const Vec3<S>& w) {
  return {{{fnma(u.x, w.x, m.e[0][0]), fnma(u.x, w.y, m.e[0][1]), fnma(u.x, w.z, m.e[0][2])},
           {fnma(u.y, w.x, m.e[1][0]), fnma(u.y, w.y, m.e[1][1]), fnma(u.y, w.z, m.e[1][2])},
           {fnma(u.z, w.x, m.e[2][0]), fnma(u.z, w.y, m.e[2][1]), fnma(u.z, w.z, m.e[2][2])}}};
}

/// m^T v.
template <class S>
MUROSIMF_INLINE Vec3<S> applyTransposed(const Matrix3<S>& m, const Vec3<S>& v) {
  return {fma(m.e[2][0], v.z, fma(m.e[1][0], v.y, m.e[0][0] * v.x)),
          fma(m.e[2][1], v.z, fma(m.e[1][1], v.y, m.e[0][1] * v.x)),
          fma(m.e[2][2], v.z, fma(m.e[1][2], v.y, m.e[0][2] * v.x))};
}

/// R m R^T for a rotation R given as a matrix.
template <class S>
MUROSIMF_INLINE Matrix3<S> turned(const Rotation<S>& r, const Matrix3<S>& m) {
  Matrix3<S> half, result;  // m R^T, then R (m R^T)
  const Vec3<S> rows[3] = {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) half.e[i][j] = dot(Vec3<S>{m.e[i][0], m.e[i][1], m.e[i][2]}, rows[j]);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.e[i][j] = dot(rows[i], Vec3<S>{half.e[0][j], half.e[1][j], half.e[2][j]});
  }
  return result;
}
template <class S>
MUROSIMF_INLINE Symmetric3<S> turned(const Rotation<S>& r, const Symmetric3<S>& m) {
  const Matrix3<S> full = turned(r, Matrix3<S>{{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}});
  return {full.e[0][0], full.e[1][1], full.e[2][2], full.e[0][1], full.e[0][2], full.e[1][2]};
}

/// The same for a turn about the coordinate axis A by the angle with this sine and cosine. With B and C the axes that
/// follow A, only the four entries in the plane of B and C mix with double angles: one product w does for all of them.
template <int A, class S>
MUROSIMF_INLINE Symmetric3<S> turnedAbout(const Symmetric3<S>& m, const SinCos<S>& angle) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  const S s = angle.sin, c = angle.cos;
  const S w = fma(s, entry<B, B>(m) - entry<C, C>(m), (c + c) * entry<B, C>(m));
  Symmetric3<S> result;
  entry<A, A>(result) = entry<A, A>(m);
  entry<A, B>(result) = fnma(s, entry<A, C>(m), c * entry<A, B>(m));
  entry<A, C>(result) = fma(c, entry<A, C>(m), s * entry<A, B>(m));
  entry<B, B>(result) = fnma(s, w, entry<B, B>(m));
  entry<C, C>(result) = fma(s, w, entry<C, C>(m));
  entry<B, C>(result) = fma(c, w, -entry<B, C>(m));
  return result;
}
template <int A, class S>
MUROSIMF_INLINE Matrix3<S> turnedAbout(const Matrix3<S>& m, const SinCos<S>& angle) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  const S s = angle.sin, c = angle.cos;
  const S both = m.e[B][C] + m.e[C][B];
  const S w = fma(s, m.e[B][B] - m.e[C][C], c * both), change = fma(c, w, -both);
  Matrix3<S> result;
  result.e[A][A] = m.e[A][A];
  result.e[A][B] = fnma(s, m.e[A][C], c * m.e[A][B]);
  result.e[A][C] = fma(c, m.e[A][C], s * m.e[A][B]);
  result.e[B][A] = fnma(s, m.e[C][A], c * m.e[B][A]);
  result.e[C][A] = fma(c, m.e[C][A], s * m.e[B][A]);
  result.e[B][B] = fnma(s, w, m.e[B][B]);
  result.e[C][C] = fma(s, w, m.e[C][C]);
  result.e[B][C] = m.e[B][C] + change;
  result.e[C][B] = m.e[C][B] + change;
  return result;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
