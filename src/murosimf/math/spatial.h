#pragma once

/// @file Six-dimensional vectors and inertias of rigid and articulated bodies [Featherstone 2008, chapters 2 and 7].
///
/// Everything is written in one frame B of the body: its axes, and its origin as the point of reference.
///   motion  (w; v)  angular velocity, and the velocity of the body's point at the origin; accelerations likewise
///   force   (n; f)  moment about the origin, and force
///   rigid body      n = I w + mc x v,   f = m v - mc x w         I about the origin, mc = mass times centre of mass
///   articulated     n = I w + H v,      f = H^T w + M v          I and M symmetric, H any matrix

#include "murosimf/math/symmetric.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S = double>
struct SpatialMotion {
  Vec3<S> w, v;

  MUROSIMF_INLINE SpatialMotion& operator+=(const SpatialMotion& b) { return w += b.w, v += b.v, *this; }
  MUROSIMF_INLINE friend SpatialMotion operator+(const SpatialMotion& a, const SpatialMotion& b) {
    return {a.w + b.w, a.v + b.v};
  }
  MUROSIMF_INLINE friend SpatialMotion operator-(const SpatialMotion& a, const SpatialMotion& b) {
    return {a.w - b.w, a.v - b.v};
  }
  MUROSIMF_INLINE friend SpatialMotion operator*(const SpatialMotion& a, S s) { return {a.w * s, a.v * s}; }
};

template <class S = double>
struct SpatialForce {
  Vec3<S> n, f;

  MUROSIMF_INLINE SpatialForce& operator+=(const SpatialForce& b) { return n += b.n, f += b.f, *this; }
  MUROSIMF_INLINE friend SpatialForce operator+(const SpatialForce& a, const SpatialForce& b) {
    return {a.n + b.n, a.f + b.f};
  }
  MUROSIMF_INLINE friend SpatialForce operator-(const SpatialForce& a, const SpatialForce& b) {
    return {a.n - b.n, a.f - b.f};
  }
  MUROSIMF_INLINE friend SpatialForce operator*(const SpatialForce& a, S s) { return {a.n * s, a.f * s}; }
};

/// Power [W].
template <class S>
MUROSIMF_INLINE S dot(const SpatialMotion<S>& a, const SpatialForce<S>& b) {
  return dot(a.w, b.n) + dot(a.v, b.f);
}
/// How fast the moving frame a changes the motion b.
template <class S>
MUROSIMF_INLINE SpatialMotion<S> cross(const SpatialMotion<S>& a, const SpatialMotion<S>& b) {
  return {cross(a.w, b.w), cross(a.w, b.v) + cross(a.v, b.w)};
}
/// How fast the moving frame a changes the force b.
template <class S>
MUROSIMF_INLINE SpatialForce<S> cross(const SpatialMotion<S>& a, const SpatialForce<S>& b) {
  return {cross(a.w, b.n) + cross(a.v, b.f), cross(a.w, b.f)};
}
template <class S = double>
struct RigidInertia {
  S m{};            ///< [kg]
  Vec3<S> mc;       ///< m p_BC [kg m]
  Symmetric3<S> I;  ///< about the origin [kg m^2]

  friend bool operator==(const RigidInertia&, const RigidInertia&) = default;
  MUROSIMF_INLINE RigidInertia& operator+=(const RigidInertia& b) { return m += b.m, mc += b.mc, I += b.I, *this; }
  MUROSIMF_INLINE friend SpatialForce<S> operator*(const RigidInertia& a, const SpatialMotion<S>& b) {
    return {a.I * b.w + cross(a.mc, b.v), b.v * a.m - cross(a.mc, b.w)};
  }
};

template <class S = double>
struct ArticulatedInertia {
  Symmetric3<S> I;
  Matrix3<S> H;
  Symmetric3<S> M;

  MUROSIMF_INLINE ArticulatedInertia& operator+=(const ArticulatedInertia& b) {
    return I += b.I, H += b.H, M += b.M, *this;
  }
  MUROSIMF_INLINE friend SpatialForce<S> operator*(const ArticulatedInertia& a, const SpatialMotion<S>& b) {
    return {a.I * b.w + a.H * b.v, applyTransposed(a.H, b.w) + a.M * b.v};
  }
};

template <class S>
MUROSIMF_INLINE ArticulatedInertia<S> select(decltype(S() < S()) mask, const ArticulatedInertia<S>& a,
                                             const ArticulatedInertia<S>& b) {
  return {select(mask, a.I, b.I), select(mask, a.H, b.H), select(mask, a.M, b.M)};
}

template <class S>
MUROSIMF_INLINE ArticulatedInertia<S> articulated(const RigidInertia<S>& rigid) {
  const S zero(0);
  const Vec3<S>& c = rigid.mc;
  return {rigid.I, {{{zero, -c.z, c.y}, {c.z, zero, -c.x}, {-c.y, c.x, zero}}}, {rigid.m, rigid.m, rigid.m}};
}

/// A rigid body is fixed to it.
template <class S>
MUROSIMF_INLINE ArticulatedInertia<S>& operator+=(ArticulatedInertia<S>& a, const RigidInertia<S>& b) {
  auto& H = a.H.e;
  a.I += b.I;
  H[0][1] -= b.mc.z, H[0][2] += b.mc.y, H[1][0] += b.mc.z, H[1][2] -= b.mc.x, H[2][0] -= b.mc.y, H[2][1] += b.mc.x;
  a.M.xx += b.m, a.M.yy += b.m, a.M.zz += b.m;
  return a;
}

/// Refers a force or an inertia to a point from which the old origin lies at r along axis A, r a number [m].
/// Offsets in general are up to three of these: that costs no more than one formula for all, and most robots have few
/// numbers in their offsets that are not zero.
template <int A, class S>
MUROSIMF_INLINE void shiftAlong(SpatialForce<S>& a, S r) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  component<B>(a.n) = fnma(r, component<C>(a.f), component<B>(a.n));
  component<C>(a.n) = fma(r, component<B>(a.f), component<C>(a.n));
}
/// H + [r]x M, I - H [r]x + [r]x (H + [r]x M)^T.
template <int A, class S>
MUROSIMF_INLINE void shiftAlong(ArticulatedInertia<S>& a, S r) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  auto& I = a.I;
  auto& H = a.H.e;
  const auto& M = a.M;
  entry<A, B>(I) = fnma(r, H[A][C], entry<A, B>(I));
  entry<A, C>(I) = fma(r, H[A][B], entry<A, C>(I));
  entry<B, B>(I) = fnma(r, H[B][C], entry<B, B>(I));
  entry<C, C>(I) = fma(r, H[C][B], entry<C, C>(I));
  entry<B, C>(I) = fma(r, H[B][B], entry<B, C>(I));
  H[B][A] = fnma(r, entry<A, C>(M), H[B][A]), H[C][A] = fma(r, entry<A, B>(M), H[C][A]);
  H[B][B] = fnma(r, entry<B, C>(M), H[B][B]), H[C][B] = fma(r, entry<B, B>(M), H[C][B]);
  H[B][C] = fnma(r, entry<C, C>(M), H[B][C]), H[C][C] = fma(r, entry<B, C>(M), H[C][C]);
  entry<B, B>(I) = fnma(r, H[B][C], entry<B, B>(I));
  entry<C, C>(I) = fma(r, H[C][B], entry<C, C>(I));
  entry<B, C>(I) = fnma(r, H[C][C], entry<B, C>(I));
}
/// A rigid body referred to a point from which the old origin lies at r.
template <class S>
MUROSIMF_INLINE RigidInertia<S> shifted(const RigidInertia<S>& a, const Vec3<S>& r) {
  // I about the new origin: I + (|r|^2 m + 2 r.mc) E - (m r r^T + r mc^T + mc r^T), with mc about the old origin.
  const Vec3<S> moved = r * a.m + a.mc;
  const S square = dot(r, moved) + dot(r, a.mc);
  RigidInertia<S> b{a.m, moved, a.I};
  b.I.xx += square - fma(moved.x, r.x, r.x * a.mc.x);
  b.I.yy += square - fma(moved.y, r.y, r.y * a.mc.y);
  b.I.zz += square - fma(moved.z, r.z, r.z * a.mc.z);
  b.I.xy -= fma(moved.x, r.y, r.x * a.mc.y);
  b.I.xz -= fma(moved.x, r.z, r.x * a.mc.z);
  b.I.yz -= fma(moved.y, r.z, r.y * a.mc.z);
  return b;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
