#pragma once

/// @file What forward dynamics of a tree have in common, whichever way they find accelerations: columns, the way inward
/// on which inertias and forces are gathered, and the way outward on which accelerations are handed on.
///
/// Inward, from the leaves to the base: the inertia Ic that a body shows with all that hangs on it, and the force p
/// that it needs when not accelerated. A joint hands on what is left of Ic behind it and
///     Ic_P += X^T Ic X,   p_P += X^T (p + Ic c),   c = V x S dq
/// Outward:  a = X a_P + c + S ddq.
/// Accelerations are proper ones, those that an accelerometer feels: gravity is an acceleration of the whole world
/// upwards by g.

#include "murosimf/algorithms/gather_rows.h"
#include "murosimf/algorithms/joint_bias.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// The tree, as tables that all robots of a batch share.
struct ArticulatedTree {
  const KernelRow* rows = nullptr;
  const GatherRow* gather = nullptr;
  int bodies = 0;
};

/// Columns, one element a body unless said; forces are in the body's axes, about its origin.
template <class S>
struct TreeDynamics {
  const SinCos<S>* turn = nullptr;    ///< of each joint: jointTurn()
  const S* joint_velocity = nullptr;  ///< of each joint
  const S* joint_torque = nullptr;    ///< of each joint: tau [N m] or [N]
  const S* joint_inertia = nullptr;   ///< of each joint: d [kg m^2] or [kg]
  const RigidInertia<S>* inertia = nullptr;
  const SpatialMotion<S>* velocity = nullptr;
  const SpatialForce<S>* force = nullptr;    ///< f0
  SpatialMotion<S>* acceleration = nullptr;  ///< result: proper, about the body's origin
  S* joint_acceleration = nullptr;           ///< result, of each joint
  // Work, overwritten.
  ArticulatedInertia<S>* slot_inertia = nullptr;  ///< of each slot of the gathering
  SpatialForce<S>* slot_bias = nullptr;           ///< of each slot
};

/// I S: one column of the inertia.
template <class Joint, class S>
MUROSIMF_INLINE SpatialForce<S> alongAxis(const ArticulatedInertia<S>& a) {
  constexpr int A = Joint::kAxis;
  const auto& H = a.H.e;
  if constexpr (Joint::kPrismatic)
    return {{H[0][A], H[1][A], H[2][A]}, {entry<0, A>(a.M), entry<1, A>(a.M), entry<2, A>(a.M)}};
  return {{entry<0, A>(a.I), entry<1, A>(a.I), entry<2, A>(a.I)}, {H[A][0], H[A][1], H[A][2]}};
}

/// p of a body by itself: what its turning costs, V x* I V, less what pushes it. By Jacobi's identity the first is
///   n = w x I w + mc x (w x v),   f = m (w x v) + w x (w x mc)
template <class S>
MUROSIMF_INLINE SpatialForce<S> bodyBias(const RigidInertia<S>& body, const SpatialMotion<S>& V,
                                         const SpatialForce<S>& force) {
  const Vec3<S> change = cross(V.w, V.v);
  return {plusCross(plusCross(-force.n, V.w, body.I * V.w), body.mc, change),
          plusCross(plusScaled(-force.f, change, body.m), V.w, cross(V.w, body.mc))};
}

/// A joint that gives way by its inertia: U U^T / D is missing behind it, with U the column of its axis and W = U / D.
template <class S>
struct YieldingJoint {
  const SpatialForce<S>&U, &W;
  MUROSIMF_INLINE Symmetric3<S> behindI(const Symmetric3<S>& m) const { return lessOuter(m, U.n, W.n); }
  MUROSIMF_INLINE Matrix3<S> behindH(const Matrix3<S>& m) const { return lessOuter(m, U.n, W.f); }
  MUROSIMF_INLINE Symmetric3<S> behindM(const Symmetric3<S>& m) const { return lessOuter(m, U.f, W.f); }
};
/// A joint behind which the whole inertia is felt.
struct LockedJoint {
  template <class Block>
  MUROSIMF_INLINE const Block& behindI(const Block& m) const {
    return m;
  }
  template <class Block>
  MUROSIMF_INLINE const Block& behindH(const Block& m) const {
    return m;
  }
  template <class Block>
  MUROSIMF_INLINE const Block& behindM(const Block& m) const {
    return m;
  }
};

/// From body i with all that hangs on it to what its parent gets of it, in place; p holds what the joint adds already.
template <class Joint, class S, class Left>
MUROSIMF_INLINE void handOn(const TreeDynamics<S>& c, int i, const Joint& joint, const Left& left,
                            ArticulatedInertia<S>& Ic, SpatialForce<S>& p) {
  const JointBias<Joint, S> bias = jointBias<Joint>(c.velocity[i], c.joint_velocity[i - 1]);
  Vec3<S> n = p.n, f = p.f;
  // What is left, then what c makes of it, then turned: block after block, because registers do not hold more than one.
  Ic.M = left.behindM(Ic.M);
  f = plusProduct(f, Ic.M, bias.v);
  Ic.M = joint.turnedOut(Ic.M);
  Ic.H = left.behindH(Ic.H);
  n = plusProduct(n, Ic.H, bias.v);
  if constexpr (!Joint::kPrismatic) f = plusTransposedProduct(f, Ic.H, bias.w);
  Ic.H = joint.turnedOut(Ic.H);
  Ic.I = left.behindI(Ic.I);
  if constexpr (!Joint::kPrismatic) n = plusProduct(n, Ic.I, bias.w);
  Ic.I = joint.turnedOut(Ic.I);
  p = {joint.turnedOut(n), joint.turnedOut(f)};
  joint.bringToParent(Ic, p);
}

/// Completes Ic and p, which hold what the row visited before handed on, by the body itself and its other children.
template <class S>
MUROSIMF_INLINE void complete(const TreeDynamics<S>& c, int i, const GatherRow& gather, ArticulatedInertia<S>& Ic,
                              SpatialForce<S>& p) {
  const SpatialForce<S> own = bodyBias(c.inertia[i], c.velocity[i], c.force[i]);
  if (gather.starts) [[unlikely]] {
    Ic = articulated(c.inertia[i]), p = own;
  } else {
    Ic += c.inertia[i], p += own;
  }
  if (gather.slot >= 0) [[unlikely]] {
    Ic += c.slot_inertia[gather.slot], p += c.slot_bias[gather.slot];
  }
}

/// Lets what body i hands on wait for its parent.
template <class S>
MUROSIMF_INLINE void putAside(const TreeDynamics<S>& c, const GatherRow& gather, const ArticulatedInertia<S>& Ic,
                              const SpatialForce<S>& p) {
  ArticulatedInertia<S>& inertia = c.slot_inertia[gather.parent_slot];
  SpatialForce<S>& bias = c.slot_bias[gather.parent_slot];
  if (gather.first) {
    inertia = Ic, bias = p;
  } else {
    inertia += Ic, bias += p;
  }
}

/// From the last body to the base, whose Ic and p it leaves there. `fold(i, Ic, p)` may add to body i an inertia and
/// the force that goes with it; `pass(i, joint, Ic, p)` hands on through the joint of body i.
template <class S, class Fold, class Pass>
MUROSIMF_INLINE void gatherInward(const ArticulatedTree& tree, const TreeDynamics<S>& c, ArticulatedInertia<S>& Ic,
                                  SpatialForce<S>& p, Fold&& fold, Pass&& pass) {
  for (int i = tree.bodies - 1; i >= 0; --i) {
    const GatherRow& gather = tree.gather[i];
    complete(c, i, gather, Ic, p);
    fold(i, Ic, p);
    if (i == 0) break;
    forJoint<S>(tree.rows[i], c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA { pass(i, joint, Ic, p); });
    if (gather.parent_slot >= 0) [[unlikely]] {
      putAside(c, gather, Ic, p);
    }
  }
}

/// Outward from the base, whose acceleration is there. rateOf(i, a): ddq of the joint that carries body i, of which a
/// is the acceleration without it.
template <class S, class RateOf>
MUROSIMF_INLINE void accelerateOutward(const ArticulatedTree& tree, const TreeDynamics<S>& c, RateOf&& rateOf) {
  for (int i = 1; i < tree.bodies; ++i) {
    const KernelRow& row = tree.rows[i];
    forJoint<S>(row, c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
      SpatialMotion<S> a = joint.into(c.acceleration[row.parent]);
      add(a, jointBias<decltype(joint)>(c.velocity[i], c.joint_velocity[i - 1]));
      const S rate = rateOf(i, a);
      joint.add(a, rate);
      c.joint_acceleration[i - 1] = rate;
      c.acceleration[i] = a;
    });
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
