#pragma once

/// @file A tree whose joints move as prescribed, seen as one body: its inertia, and the momentum of its inner motion.
///
/// From the leaves to the base, with Ic the inertia of all that hangs on a joint, as if welded [Featherstone
/// 2008, 6.2]:
///     g_i += Ic_i S dq,   Ic_P += X^T Ic_i X,   g_P += X^T g_i
/// Then the momentum of the whole about the base's origin is  h = Ic_0 V_0 + g_0,  V_0 the base's velocity, and no
/// body's own velocity is needed: a column of Ic is five numbers. Cost: about 60 multiplications and additions a joint.

#include "murosimf/algorithms/tree_dynamics.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// All that hangs on a body, and the body, in its axes about its origin.
template <class S = double>
struct CompositeMotion {
  RigidInertia<S> inertia;   ///< Ic
  SpatialForce<S> momentum;  ///< g
  MUROSIMF_INLINE CompositeMotion& operator+=(const CompositeMotion& b) {
    inertia += b.inertia, momentum += b.momentum;
    return *this;
  }
};

/// g += Ic S dq.
template <class Joint, class S>
MUROSIMF_INLINE void addJointMomentum(CompositeMotion<S>& a, S rate) {
  constexpr int A = Joint::kAxis, B = (A + 1) % 3, C = (A + 2) % 3;
  const Vec3<S>& mc = a.inertia.mc;
  Vec3<S>&n = a.momentum.n, &f = a.momentum.f;
  if constexpr (Joint::kPrismatic) {
    component<A>(f) = fma(a.inertia.m, rate, component<A>(f));
    component<B>(n) = fma(component<C>(mc), rate, component<B>(n));
    component<C>(n) = fnma(component<B>(mc), rate, component<C>(n));
  } else {
    component<A>(n) = fma(entry<A, A>(a.inertia.I), rate, component<A>(n));
    component<B>(n) = fma(entry<A, B>(a.inertia.I), rate, component<B>(n));
    component<C>(n) = fma(entry<A, C>(a.inertia.I), rate, component<C>(n));
    component<B>(f) = fnma(component<C>(mc), rate, component<B>(f));
    component<C>(f) = fma(component<B>(mc), rate, component<C>(f));
  }
}

/// The same about a point from which the old origin lies at r along axis A [m]. Offsets of joints are mostly along one
/// or two axes.
template <int A, class S>
MUROSIMF_INLINE void shiftAlong(CompositeMotion<S>& a, S r) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  Vec3<S>& mc = a.inertia.mc;
  auto& I = a.inertia.I;
  const S moved = fma(a.inertia.m, r, component<A>(mc)), both = component<A>(mc) + moved;
  entry<B, B>(I) = fma(r, both, entry<B, B>(I));
  entry<C, C>(I) = fma(r, both, entry<C, C>(I));
  entry<A, B>(I) = fnma(r, component<B>(mc), entry<A, B>(I));
  entry<A, C>(I) = fnma(r, component<C>(mc), entry<A, C>(I));
  component<A>(mc) = moved;
  Vec3<S>& n = a.momentum.n;
  const Vec3<S>& f = a.momentum.f;
  component<B>(n) = fnma(r, component<C>(f), component<B>(n));
  component<C>(n) = fma(r, component<B>(f), component<C>(n));
}

/// From the axes of a row's body, about its origin, to those of its parent.
template <class Joint, class S>
MUROSIMF_INLINE void bringOut(const KernelRow& row, const Joint& joint, CompositeMotion<S>& a) {
  constexpr int A = Joint::kAxis;
  if constexpr (Joint::kPrismatic) {
    shiftAlong<A>(a, joint.turn.sin);
  } else {
    a.inertia = {a.inertia.m, turnedAbout<A>(a.inertia.mc, joint.turn), turnedAbout<A>(a.inertia.I, joint.turn)};
    a.momentum = {turnedAbout<A>(a.momentum.n, joint.turn), turnedAbout<A>(a.momentum.f, joint.turn)};
  }
  if (row.turned) {
    const Rotation<S> R_PF = rotationFrom<S>(row.rotation);
    a.inertia = {a.inertia.m, R_PF * a.inertia.mc, turned(R_PF, a.inertia.I)};
    a.momentum = {R_PF * a.momentum.n, R_PF * a.momentum.f};
  }
  if (row.translation[0] != 0) shiftAlong<0>(a, S(row.translation[0]));
  if (row.translation[1] != 0) shiftAlong<1>(a, S(row.translation[1]));
  if (row.translation[2] != 0) shiftAlong<2>(a, S(row.translation[2]));
}

/// Of the whole tree, in the axes of its base. turnOf(i) and rateOf(i): of the joint of row i. `inertia` is a column
/// with one element a body, `slots` work with one element a slot of the gathering.
template <class S, class TurnOf, class RateOf>
MUROSIMF_INLINE CompositeMotion<S> compositeMotion(const ArticulatedTree& tree, const RigidInertia<S>* inertia,
                                                   CompositeMotion<S>* slots, TurnOf&& turnOf, RateOf&& rateOf) {
  const S o(0);
  CompositeMotion<S> whole;  // of the row and of what hangs on it
  for (int i = tree.bodies - 1;; --i) {
    const GatherRow& gather = tree.gather[i];
    if (gather.starts) {
      whole = {inertia[i], {{o, o, o}, {o, o, o}}};
    } else {
      whole.inertia += inertia[i];
    }
    if (gather.slot >= 0) whole += slots[gather.slot];
    if (i == 0) return whole;
    forJoint<S>(tree.rows[i], turnOf(i), [&](const auto& joint) MUROSIMF_INLINE_LAMBDA {
      addJointMomentum<std::remove_cvref_t<decltype(joint)>>(whole, rateOf(i));
      bringOut(tree.rows[i], joint, whole);
    });
    if (gather.parent_slot < 0) continue;
    if (gather.first) {
      slots[gather.parent_slot] = whole;
    } else {
      slots[gather.parent_slot] += whole;
    }
  }
}

/// Sines and cosines of all joints after they have moved by `way` each, from those before: up to pi/4 [rad] in full
/// accuracy, any way [m] for joints that slide. wayOf(j): of joint j. Two loops, each with few enough constants for the
/// registers.
template <class S, class WayOf>
MUROSIMF_INLINE void turnAhead(const KernelRow* rows, int joints, const SinCos<S>* turn, SinCos<S>* ahead,
                               WayOf&& wayOf) {
  for (int j = 0; j < joints; ++j) ahead[j].sin = sinKernel(wayOf(j));
  for (int j = 0; j < joints; ++j) {
    const S s = ahead[j].sin, c = cosKernel(wayOf(j));
    ahead[j] = {fma(turn[j].sin, c, turn[j].cos * s), fnma(turn[j].sin, s, turn[j].cos * c)};
    if (rows[j + 1].prismatic) ahead[j] = {turn[j].sin + wayOf(j), turn[j].cos};
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
