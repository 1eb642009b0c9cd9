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

/// The inertia referred to a point from which the old origin lies at r: H + [r]x M, I - H [r]x + [r]x (H + [r]x M)^T.
template <class S>
MUROSIMF_INLINE ArticulatedInertia<S> shifted(const ArticulatedInertia<S>& a, const Vec3<S>& r) {
  ArticulatedInertia<S> b;
  const Symmetric3<S>& M = b.M = a.M;
  const auto& H = a.H.e;
  auto& G = b.H.e;
  G[0][0] = fma(r.y, M.xz, fnma(r.z, M.xy, H[0][0]));
  G[0][1] = fma(r.y, M.yz, fnma(r.z, M.yy, H[0][1]));
  G[0][2] = fma(r.y, M.zz, fnma(r.z, M.yz, H[0][2]));
  G[1][0] = fma(r.z, M.xx, fnma(r.x, M.xz, H[1][0]));
  G[1][1] = fma(r.z, M.xy, fnma(r.x, M.yz, H[1][1]));
  G[1][2] = fma(r.z, M.xz, fnma(r.x, M.zz, H[1][2]));
  G[2][0] = fma(r.x, M.xy, fnma(r.y, M.xx, H[2][0]));
  G[2][1] = fma(r.x, M.yy, fnma(r.y, M.xy, H[2][1]));
  G[2][2] = fma(r.x, M.yz, fnma(r.y, M.xz, H[2][2]));
  // -(H [r]x)_ij + ([r]x G^T)_ij
  b.I.xx = fma(r.y, G[0][2], fnma(r.z, G[0][1], fma(r.y, H[0][2], fnma(r.z, H[0][1], a.I.xx))));
  b.I.xy = fma(r.y, G[1][2], fnma(r.z, G[1][1], fma(r.z, H[0][0], fnma(r.x, H[0][2], a.I.xy))));
  b.I.xz = fma(r.y, G[2][2], fnma(r.z, G[2][1], fma(r.x, H[0][1], fnma(r.y, H[0][0], a.I.xz))));
  b.I.yy = fma(r.z, G[1][0], fnma(r.x, G[1][2], fma(r.z, H[1][0], fnma(r.x, H[1][2], a.I.yy))));
  b.I.yz = fma(r.z, G[2][0], fnma(r.x, G[2][2], fma(r.x, H[1][1], fnma(r.y, H[1][0], a.I.yz))));
  b.I.zz = fma(r.x, G[2][1], fnma(r.y, G[2][0], fma(r.x, H[2][1], fnma(r.y, H[2][0], a.I.zz))));
  return b;
}
/// The same for a rigid body.
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
