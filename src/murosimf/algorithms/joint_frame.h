#pragma once

/// @file The step from a body of a tree to the next one, for recursions that carry velocities, forces and inertias.
///
/// A row of the table puts the child's frame C at X_PC = X_PF J(q) of its parent P. JointFrame is that pose for one
/// row, with the joint's axis and kind known to the compiler: a turn about a coordinate axis mixes two components and
/// leaves the third alone, which is a third of the work of a general rotation. forJoint() chooses among the six kinds.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/math/spatial.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// J v for a turn J about the coordinate axis A.
template <int A, class S>
MUROSIMF_INLINE Vec3<S> turnedAbout(const Vec3<S>& v, const SinCos<S>& angle) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  Vec3<S> result = v;
  component<B>(result) = fnma(angle.sin, component<C>(v), angle.cos * component<B>(v));
  component<C>(result) = fma(angle.cos, component<C>(v), angle.sin * component<B>(v));
  return result;
}
/// J^T v.
template <int A, class S>
MUROSIMF_INLINE Vec3<S> turnedBackAbout(const Vec3<S>& v, const SinCos<S>& angle) {
  return turnedAbout<A>(v, SinCos<S>{-angle.sin, angle.cos});
}

/// What a joint's position does to its frame: sine and cosine of a revolute joint's angle; for a prismatic joint its
/// displacement [m] stands in the place of the sine.
template <class S>
inline SinCos<S> jointTurn(const KernelRow& row, S q) {
  return row.prismatic ? SinCos<S>{q, S(1)} : sincos(q);
}

/// X_PC of one row. A: axis of the joint.
template <int A, bool kSlides, class S>
struct JointFrame {
  static constexpr int kAxis = A;
  static constexpr bool kPrismatic = kSlides;

  const KernelRow& row;
  const SinCos<S> turn;

  /// R_CP v: a vector of the parent in the child's axes.
  MUROSIMF_INLINE Vec3<S> into(const Vec3<S>& v) const {
    const Vec3<S> u = row.turned ? applyTransposed(rotationFrom<S>(row.rotation), v) : v;
    return kSlides ? u : turnedBackAbout<A>(u, turn);
  }
  /// R_PC v.
  MUROSIMF_INLINE Vec3<S> outOf(const Vec3<S>& v) const {
    const Vec3<S> u = kSlides ? v : turnedAbout<A>(v, turn);
    return row.turned ? rotationFrom<S>(row.rotation) * u : u;
  }
  /// p_PC: the child's origin from the parent's, in the parent's axes.
  MUROSIMF_INLINE Vec3<S> origin() const {
    const Vec3<S> p{S(row.translation[0]), S(row.translation[1]), S(row.translation[2])};
    if constexpr (!kSlides) return p;
    const double* a = row.rotation + 3 * A;  // R_PF e_A
    return {fma(S(a[0]), turn.sin, p.x), fma(S(a[1]), turn.sin, p.y), fma(S(a[2]), turn.sin, p.z)};
  }
  MUROSIMF_INLINE SpatialMotion<S> into(const SpatialMotion<S>& a) const {
    return {into(a.w), into(plusCross(a.v, a.w, origin()))};
  }
  MUROSIMF_INLINE SpatialForce<S> outOf(const SpatialForce<S>& a) const {
    const Vec3<S> f = outOf(a.f);
    return {plusCross(outOf(a.n), origin(), f), f};
  }
  /// J m J^T or J v: without the turn of a revolute joint.
  template <class T>
  MUROSIMF_INLINE T turnedOut(const T& m) const {
    if constexpr (kSlides) {
      return m;
    } else {
      return turnedAbout<A>(m, turn);
    }
  }
  /// What is left of the way to the parent for an inertia and a force that have been turned out.
  MUROSIMF_INLINE void bringToParent(ArticulatedInertia<S>& a, SpatialForce<S>& p) const {
    if constexpr (kSlides) shiftAlong<A>(a, turn.sin), shiftAlong<A>(p, turn.sin);
    if (row.turned) [[unlikely]] {
      const Rotation<S> R_PF = rotationFrom<S>(row.rotation);
      a = {turned(R_PF, a.I), turned(R_PF, a.H), turned(R_PF, a.M)};
      p = {R_PF * p.n, R_PF * p.f};
    }
    bringAlong<0>(a, p), bringAlong<1>(a, p), bringAlong<2>(a, p);
  }
  /// The same for a force alone.
  MUROSIMF_INLINE void bringToParent(SpatialForce<S>& p) const {
    if constexpr (kSlides) shiftAlong<A>(p, turn.sin);
    if (row.turned) [[unlikely]] {
      const Rotation<S> R_PF = rotationFrom<S>(row.rotation);
      p = {R_PF * p.n, R_PF * p.f};
    }
    bringAlong<0>(p), bringAlong<1>(p), bringAlong<2>(p);
  }
  MUROSIMF_INLINE RigidInertia<S> outOf(RigidInertia<S> a) const {
    if constexpr (!kSlides) a = {a.m, turnedAbout<A>(a.mc, turn), turnedAbout<A>(a.I, turn)};
    if (row.turned) {
      const Rotation<S> R_PF = rotationFrom<S>(row.rotation);
      a = {a.m, R_PF * a.mc, turned(R_PF, a.I)};
    }
    return shifted(a, origin());
  }
  template <int K>
  MUROSIMF_INLINE void bringAlong(ArticulatedInertia<S>& a, SpatialForce<S>& p) const {
    if (row.translation[K] == 0) return;
    const S r(row.translation[K]);
    shiftAlong<K>(a, r), shiftAlong<K>(p, r);
  }
  template <int K>
  MUROSIMF_INLINE void bringAlong(SpatialForce<S>& p) const {
    if (row.translation[K] != 0) shiftAlong<K>(p, S(row.translation[K]));
  }
  /// The component of a force that the joint's motor feels: S^T f.
  static S along(const SpatialForce<S>& a) { return component<A>(kSlides ? a.f : a.n); }
  static S along(const SpatialMotion<S>& a) { return component<A>(kSlides ? a.v : a.w); }
  /// a += S rate: the joint's own motion.
  static void add(SpatialMotion<S>& a, S rate) { component<A>(kSlides ? a.v : a.w) += rate; }
  /// S rate.
  static SpatialMotion<S> motion(S rate) {
    SpatialMotion<S> result{{S(0), S(0), S(0)}, {S(0), S(0), S(0)}};
    component<A>(kSlides ? result.v : result.w) = rate;
    return result;
  }
};

/// Calls visit(frame) with the frame of this row's joint.
template <class S, class Visit>
MUROSIMF_INLINE void forJoint(const KernelRow& row, const SinCos<S>& turn, Visit&& visit) {
  switch (row.axis + (row.prismatic ? 3 : 0)) {
    case 0:
      return visit(JointFrame<0, false, S>{row, turn});
    case 1:
      return visit(JointFrame<1, false, S>{row, turn});
    case 2:
      return visit(JointFrame<2, false, S>{row, turn});
    case 3:
      return visit(JointFrame<0, true, S>{row, turn});
    case 4:
      return visit(JointFrame<1, true, S>{row, turn});
    default:
      return visit(JointFrame<2, true, S>{row, turn});
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
