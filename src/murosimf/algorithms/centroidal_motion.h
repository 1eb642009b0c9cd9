#pragma once

/// @file The motion of a whole robot whose joints move as prescribed: centre of mass and angular momentum.
///
///   dv/dt = F/m,   dL/dt = N,   L = I w + s,   dR/dt = [w]x R
///
/// with v the velocity of the centre of mass, L the angular momentum about it, s the part of L that the joints' motion
/// relative to the base has, I the inertia of the tree as if welded [Orin, Goswami, Lee 2013]. Neither w's rate nor a
/// gyroscopic term is needed, a jump of the joints' rates gives the right jump of w, and without forces L stays as it
/// is whatever the step. One step of length h:
///   p+ = p + h (v + v+)/2,   v+ = v + h F/m,   L+ = L + h N
///   R_mid = exp(h/2 [w_0]) R,   R+ = exp(h [w_mid]) R,   w_0 and w_mid of (L + L+)/2:  order 2 [Hairer, Lubich, Wanner
///   2006, VII.5]
/// Then base pose and velocity follow: p_WB = p - R c,  v_B = v - w x c - dc/dt.

#include "murosimf/math/spatial.h"
#include "murosimf/math/transform.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// What moves a robot over a step. Its own columns: base axes unless said, all of the joints at the end of the step.
template <class S = double>
struct CentroidalStep {
  S mass{};
  Vec3<S> centre, centre_rate;  ///< c from the base's origin, and its rate relative to the base [m], [m/s]
  Symmetric3<S> inertia;        ///< I about the centre [kg m^2]
  Vec3<S> spin;                 ///< s [kg m^2/s]
  Vec3<S> p, v, L;              ///< of the centre at the beginning, world axes
  Vec3<S> force, moment;        ///< F with gravity, and N, mean over the step, world axes
};

/// m^-1, by cofactors.
template <class S>
MUROSIMF_INLINE Symmetric3<S> inverse(const Symmetric3<S>& m) {
  const S xx = fnma(m.yz, m.yz, m.yy * m.zz), xy = fnma(m.xy, m.zz, m.xz * m.yz), xz = fnma(m.xz, m.yy, m.xy * m.yz);
  const S scale = S(1) / fma(m.xz, xz, fma(m.xy, xy, m.xx * xx));
  return {xx * scale, fnma(m.xz, m.xz, m.xx * m.zz) * scale, fnma(m.xy, m.xy, m.xx * m.yy) * scale, xy * scale,
          xz * scale, fnma(m.xx, m.yz, m.xy * m.xz) * scale};
}

/// The inertia about the centre of mass c of a body with I about its origin.
template <class S>
MUROSIMF_INLINE Symmetric3<S> aboutCentre(const RigidInertia<S>& body, const Vec3<S>& c) {
  const Vec3<S>& mc = body.mc;
  const Symmetric3<S>& I = body.I;
  const S xx = mc.x * c.x, yy = mc.y * c.y, zz = mc.z * c.z;
  return {I.xx - (yy + zz),     I.yy - (zz + xx),     I.zz - (xx + yy),
          fma(mc.x, c.y, I.xy), fma(mc.x, c.z, I.xz), fma(mc.y, c.z, I.yz)};
}

/// exp([phi]x) v up to the second order.
template <class S>
MUROSIMF_INLINE Vec3<S> nearlyTurned(const Vec3<S>& phi, const Vec3<S>& v) {
  const Vec3<S> once = cross(phi, v);
  return v + once + cross(phi, once) * S(0.5);
}

/// Moves the base by one step; V in base axes, result only.
template <class S>
MUROSIMF_INLINE void advance(const CentroidalStep<S>& a, S h, Transform<S>& X_WB, SpatialMotion<S>& V) {
  const Symmetric3<S> inverse_inertia = inverse(a.inertia);
  const Vec3<S> v = a.v + a.force * (h / a.mass), p = a.p + (a.v + v) * (S(0.5) * h);
  const Vec3<S> L = a.L + a.moment * h;
  const Vec3<S> L_mean = applyTransposed(X_WB.rotation, (a.L + L) * S(0.5));
  const Vec3<S> w_0 = inverse_inertia * (L_mean - a.spin);
  const Vec3<S> w_mid = inverse_inertia * (nearlyTurned(w_0 * (S(-0.5) * h), L_mean) - a.spin);
  X_WB.rotation = orthonormalized(X_WB.rotation * rotationExp(w_mid * h));
  X_WB.translation = p - X_WB.rotation * a.centre;
  V.w = inverse_inertia * (applyTransposed(X_WB.rotation, L) - a.spin);
  V.v = applyTransposed(X_WB.rotation, v) - cross(V.w, a.centre) - a.centre_rate;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
