#pragma once

/// @file Forward dynamics of a tree with a floating base: the articulated-body algorithm [Featherstone 2008, 7.3].
///
/// Given joint torques and forces on bodies, finds the accelerations. From the leaves to the base, with IA the inertia
/// that a body shows to its parent with all that hangs on it, and pA the force that it needs when not accelerated:
///     U = IA S,   D = S^T U + d,   u = tau - S^T pA
///     Ia = IA - U D^-1 U^T,   pa = pA + Ia c + U D^-1 u,   c = V x S dq
///     IA_P += X^T Ia X,   pA_P += X^T pa
/// then IA_0 a_0 = -pA_0 for the base, and outwards  ddq = D^-1 (u - U^T a'),  a = a' + S ddq,  a' = X a_P + c.
///
/// d is inertia at the joint itself: the rotor's, and what an implicit servo adds. Accelerations are proper ones, those
/// that an accelerometer feels: gravity is an acceleration of the whole world upwards by g.
/// A force may depend on the acceleration that it causes, f = f0 - K a, as an implicit contact's does: K then joins the
/// body's inertia, and since K answers to the true acceleration, what it would owe to gravity is put back.
/// Cost: about 380 multiplications and additions a joint; O(bodies), no matrix of the whole robot.

#include "murosimf/algorithms/base_equation.h"
#include "murosimf/algorithms/gather_rows.h"
#include "murosimf/algorithms/joint_bias.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// What the way back from the base needs to know of a joint.
template <class S>
struct JointResponse {
  SpatialForce<S> U_over_D;  ///< U D^-1
  S u_over_D{};              ///< u D^-1 [rad/s^2]
};

/// The tree, as tables that all robots of a batch share.
struct ArticulatedTree {
  const KernelRow* rows = nullptr;
  const GatherRow* gather = nullptr;
  int bodies = 0;
};

/// Columns, one element a body unless said; forces are in the body's axes, about its origin.
template <class S>
struct ArticulatedBody {
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
  JointResponse<S>* response = nullptr;           ///< of each joint
  ArticulatedInertia<S>* slot_inertia = nullptr;  ///< of each slot of the gathering
  SpatialForce<S>* slot_bias = nullptr;           ///< of each slot
};

/// U = IA S: one column of the inertia.
template <class Joint, class S>
MUROSIMF_INLINE SpatialForce<S> alongAxis(const ArticulatedInertia<S>& a) {
  constexpr int A = Joint::kAxis;
  const auto& H = a.H.e;
  if constexpr (Joint::kPrismatic)
    return {{H[0][A], H[1][A], H[2][A]}, {entry<0, A>(a.M), entry<1, A>(a.M), entry<2, A>(a.M)}};
  return {{entry<0, A>(a.I), entry<1, A>(a.I), entry<2, A>(a.I)}, {H[A][0], H[A][1], H[A][2]}};
}

/// pA of a body by itself: what its turning costs, V x* I V, less what pushes it. By Jacobi's identity the first is
///   n = w x I w + mc x (w x v),   f = m (w x v) + w x (w x mc)
template <class S>
MUROSIMF_INLINE SpatialForce<S> bodyBias(const RigidInertia<S>& body, const SpatialMotion<S>& V,
                                         const SpatialForce<S>& force) {
  const Vec3<S> change = cross(V.w, V.v);
  return {plusCross(plusCross(-force.n, V.w, body.I * V.w), body.mc, change),
          plusCross(plusScaled(-force.f, change, body.m), V.w, cross(V.w, body.mc))};
}

/// From body i with all that hangs on it to what its parent gets of it, in place.
template <class Joint, class S>
MUROSIMF_INLINE void handInward(const ArticulatedBody<S>& c, int i, const Joint& joint, ArticulatedInertia<S>& IA,
                                SpatialForce<S>& pA) {
  const SpatialForce<S> U = alongAxis<Joint>(IA);
  const S over_D = S(1) / (joint.along(U) + c.joint_inertia[i - 1]);
  const SpatialForce<S> W = U * over_D;
  const S u = c.joint_torque[i - 1] - joint.along(pA);
  c.response[i - 1] = {W, u * over_D};
  const JointBias<Joint, S> bias = jointBias<Joint>(c.velocity[i], c.joint_velocity[i - 1]);
  Vec3<S> n = plusScaled(pA.n, W.n, u), f = plusScaled(pA.f, W.f, u);
  // Ia, then what c makes of it, then turned: block after block, because registers do not hold more than one.
  IA.M = lessOuter(IA.M, U.f, W.f);
  f = plusProduct(f, IA.M, bias.v);
  IA.M = joint.turnedOut(IA.M);
  IA.H = lessOuter(IA.H, U.n, W.f);
  n = plusProduct(n, IA.H, bias.v);
  if constexpr (!Joint::kPrismatic) f = plusTransposedProduct(f, IA.H, bias.w);
  IA.H = joint.turnedOut(IA.H);
  IA.I = lessOuter(IA.I, U.n, W.n);
  if constexpr (!Joint::kPrismatic) n = plusProduct(n, IA.I, bias.w);
  IA.I = joint.turnedOut(IA.I);
  pA = {joint.turnedOut(n), joint.turnedOut(f)};
  joint.bringToParent(IA, pA);
}

/// Completes IA and pA, which hold what the row visited before handed on, by the body itself and its other children.
template <class S>
MUROSIMF_INLINE void complete(const ArticulatedBody<S>& c, int i, const GatherRow& gather, ArticulatedInertia<S>& IA,
                              SpatialForce<S>& pA) {
  const SpatialForce<S> own = bodyBias(c.inertia[i], c.velocity[i], c.force[i]);
  if (gather.starts) [[unlikely]] {
    IA = articulated(c.inertia[i]), pA = own;
  } else {
    IA += c.inertia[i], pA += own;
  }
  if (gather.slot >= 0) [[unlikely]] {
    IA += c.slot_inertia[gather.slot], pA += c.slot_bias[gather.slot];
  }
}

/// Lets what body i hands on wait for its parent.
template <class S>
MUROSIMF_INLINE void putAside(const ArticulatedBody<S>& c, const GatherRow& gather, const ArticulatedInertia<S>& IA,
                              const SpatialForce<S>& pA) {
  ArticulatedInertia<S>& inertia = c.slot_inertia[gather.parent_slot];
  SpatialForce<S>& bias = c.slot_bias[gather.parent_slot];
  if (gather.first) {
    inertia = IA, bias = pA;
  } else {
    inertia += IA, bias += pA;
  }
}

/// Inward from the last body to the base, whose acceleration it finds. `fold(i, IA, pA)` may add to body i an inertia K
/// and the force that goes with it.
template <class S, class Fold>
MUROSIMF_INLINE void articulatedInward(const ArticulatedTree& tree, const ArticulatedBody<S>& c, Fold&& fold) {
  ArticulatedInertia<S> IA;
  SpatialForce<S> pA;
  for (int i = tree.bodies - 1; i >= 0; --i) {
    const GatherRow& gather = tree.gather[i];
    complete(c, i, gather, IA, pA);
    fold(i, IA, pA);
    if (i == 0) break;
    forJoint<S>(tree.rows[i], c.turn[i - 1],
                [&](auto joint) MUROSIMF_INLINE_LAMBDA { handInward(c, i, joint, IA, pA); });
    if (gather.parent_slot >= 0) [[unlikely]] {
      putAside(c, gather, IA, pA);
    }
  }
  c.acceleration[0] = solved(IA, pA) * S(-1);
}

/// Outward from the base, whose acceleration is there.
template <class S>
MUROSIMF_INLINE void articulatedOutward(const ArticulatedTree& tree, const ArticulatedBody<S>& c) {
  for (int i = 1; i < tree.bodies; ++i) {
    const KernelRow& row = tree.rows[i];
    forJoint<S>(row, c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
      const JointResponse<S>& response = c.response[i - 1];
      SpatialMotion<S> a = joint.into(c.acceleration[row.parent]);
      add(a, jointBias<decltype(joint)>(c.velocity[i], c.joint_velocity[i - 1]));
      const S rate = response.u_over_D - dot(a, response.U_over_D);
      joint.add(a, rate);
      c.joint_acceleration[i - 1] = rate;
      c.acceleration[i] = a;
    });
  }
}

template <class S>
MUROSIMF_INLINE void articulatedBody(const ArticulatedTree& tree, const ArticulatedBody<S>& c) {
  articulatedInward(tree, c, [](int, ArticulatedInertia<S>&, SpatialForce<S>&) {});
  articulatedOutward(tree, c);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
