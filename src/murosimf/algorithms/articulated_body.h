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
/// Cost: about 500 multiplications and additions a joint; O(bodies), no matrix of the whole robot.

#include "murosimf/algorithms/base_equation.h"
#include "murosimf/algorithms/gather_rows.h"
#include "murosimf/algorithms/joint_frame.h"

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

/// c = V x S dq: how the turning of the body changes the joint's own motion.
template <class Joint, class S>
MUROSIMF_INLINE SpatialMotion<S> jointBias(const SpatialMotion<S>& velocity, S rate) {
  constexpr int B = (Joint::kAxis + 1) % 3, C = (Joint::kAxis + 2) % 3;
  const auto crossAxis = [&](const Vec3<S>& a) MUROSIMF_INLINE_LAMBDA {
    Vec3<S> result{S(0), S(0), S(0)};
    component<B>(result) = component<C>(a) * rate;
    component<C>(result) = -(component<B>(a) * rate);
    return result;
  };
  if constexpr (Joint::kPrismatic) return {{S(0), S(0), S(0)}, crossAxis(velocity.w)};
  return {crossAxis(velocity.w), crossAxis(velocity.v)};
}

/// U = IA S: one column of the inertia.
template <class Joint, class S>
MUROSIMF_INLINE SpatialForce<S> alongAxis(const ArticulatedInertia<S>& a) {
  constexpr int A = Joint::kAxis;
  const auto& H = a.H.e;
  if constexpr (Joint::kPrismatic)
    return {{H[0][A], H[1][A], H[2][A]}, {entry<0, A>(a.M), entry<1, A>(a.M), entry<2, A>(a.M)}};
  return {{entry<0, A>(a.I), entry<1, A>(a.I), entry<2, A>(a.I)}, {H[A][0], H[A][1], H[A][2]}};
}

/// a -= U W^T, W = U D^-1.
template <class S>
MUROSIMF_INLINE void subtract(ArticulatedInertia<S>& a, const SpatialForce<S>& U, const SpatialForce<S>& W) {
  const auto symmetric = [](Symmetric3<S>& m, const Vec3<S>& u, const Vec3<S>& w) MUROSIMF_INLINE_LAMBDA {
    m.xx = fnma(u.x, w.x, m.xx), m.yy = fnma(u.y, w.y, m.yy), m.zz = fnma(u.z, w.z, m.zz);
    m.xy = fnma(u.x, w.y, m.xy), m.xz = fnma(u.x, w.z, m.xz), m.yz = fnma(u.y, w.z, m.yz);
  };
  symmetric(a.I, U.n, W.n);
  symmetric(a.M, U.f, W.f);
  const S u[3] = {U.n.x, U.n.y, U.n.z}, w[3] = {W.f.x, W.f.y, W.f.z};
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < 3; ++j) a.H.e[i][j] = fnma(u[i], w[j], a.H.e[i][j]);
  }
}

/// pA of a body by itself: what its turning costs, less what pushes it.
template <class S>
MUROSIMF_INLINE SpatialForce<S> bodyBias(const ArticulatedBody<S>& c, int i) {
  return cross(c.velocity[i], c.inertia[i] * c.velocity[i]) - c.force[i];
}

/// Body i and all that hangs on it, complete; then what its parent gets of it.
template <class Joint, class S>
MUROSIMF_INLINE void handInward(const ArticulatedBody<S>& c, int i, const GatherRow& gather, const Joint& joint,
                                ArticulatedInertia<S> IA, const SpatialForce<S>& pA) {
  const SpatialForce<S> U = alongAxis<Joint>(IA);
  const S over_D = S(1) / (joint.along(U) + c.joint_inertia[i - 1]);
  const SpatialForce<S> W = U * over_D;
  const S u = c.joint_torque[i - 1] - joint.along(pA);
  c.response[i - 1] = {W, u * over_D};
  subtract(IA, U, W);
  const SpatialMotion<S> bias = jointBias<Joint>(c.velocity[i], c.joint_velocity[i - 1]);
  const SpatialForce<S> pa = joint.outOf(pA + IA * bias + W * u);
  IA = joint.outOf(IA);
  ArticulatedInertia<S>& parent_inertia = c.slot_inertia[gather.parent_slot];
  SpatialForce<S>& parent_bias = c.slot_bias[gather.parent_slot];
  if (gather.first) {
    parent_inertia = IA, parent_bias = pa;
  } else {
    parent_inertia += IA, parent_bias += pa;
  }
}

/// Inward from body `last` to the base, whose acceleration it finds. `fold(i, IA, pA)` may add to body i an inertia K
/// and the force that goes with it.
template <class S, class Fold>
MUROSIMF_INLINE void articulatedInward(const ArticulatedTree& tree, const ArticulatedBody<S>& c, Fold&& fold) {
  for (int i = tree.bodies - 1; i >= 0; --i) {
    const GatherRow gather = tree.gather[i];
    ArticulatedInertia<S> IA = articulated(c.inertia[i]);
    SpatialForce<S> pA = bodyBias(c, i);
    if (gather.slot >= 0) IA += c.slot_inertia[gather.slot], pA += c.slot_bias[gather.slot];
    fold(i, IA, pA);
    if (i == 0) {
      c.acceleration[0] = solved(IA, pA) * S(-1);
    } else {
      forJoint<S>(tree.rows[i], c.turn[i - 1],
                  [&](auto joint) MUROSIMF_INLINE_LAMBDA { handInward(c, i, gather, joint, IA, pA); });
    }
  }
}

/// Outward from the base, whose acceleration is there.
template <class S>
MUROSIMF_INLINE void articulatedOutward(const ArticulatedTree& tree, const ArticulatedBody<S>& c) {
  for (int i = 1; i < tree.bodies; ++i) {
    const KernelRow& row = tree.rows[i];
    forJoint<S>(row, c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
      const JointResponse<S>& response = c.response[i - 1];
      SpatialMotion<S> a = joint.into(c.acceleration[row.parent]);
      a += jointBias<decltype(joint)>(c.velocity[i], c.joint_velocity[i - 1]);
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
