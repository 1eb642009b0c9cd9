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
#include "murosimf/algorithms/tree_dynamics.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// What the way back from the base needs to know of a joint.
template <class S>
struct JointResponse {
  SpatialForce<S> U_over_D;  ///< U D^-1
  S u_over_D{};              ///< u D^-1 [rad/s^2]
};

template <class S>
struct ArticulatedBody {
  TreeDynamics<S> tree;
  JointResponse<S>* response = nullptr;  ///< work, overwritten: of each joint
};

/// From body i with all that hangs on it to what its parent gets of it, in place.
template <class Joint, class S>
MUROSIMF_INLINE void handInward(const ArticulatedBody<S>& c, int i, const Joint& joint, ArticulatedInertia<S>& IA,
                                SpatialForce<S>& pA) {
  const SpatialForce<S> U = alongAxis<Joint>(IA);
  const S over_D = S(1) / (joint.along(U) + c.tree.joint_inertia[i - 1]);
  const SpatialForce<S> W = U * over_D;
  const S u = c.tree.joint_torque[i - 1] - joint.along(pA);
  c.response[i - 1] = {W, u * over_D};
  pA = {plusScaled(pA.n, W.n, u), plusScaled(pA.f, W.f, u)};
  handOn(c.tree, i, joint, YieldingJoint<S>{U, W}, IA, pA);
}

/// Inward from the last body to the base, whose acceleration it finds. `fold(i, IA, pA)` may add to body i an inertia K
/// and the force that goes with it.
template <class S, class Fold>
MUROSIMF_INLINE void articulatedInward(const ArticulatedTree& tree, const ArticulatedBody<S>& c, Fold&& fold) {
  ArticulatedInertia<S> IA;
  SpatialForce<S> pA;
  gatherInward(tree, c.tree, IA, pA, fold,
               [&](int i, const auto& joint, ArticulatedInertia<S>& Ic, SpatialForce<S>& p)
                   MUROSIMF_INLINE_LAMBDA { handInward(c, i, joint, Ic, p); });
  c.tree.acceleration[0] = solved(IA, pA) * S(-1);
}

/// Outward from the base, whose acceleration is there.
template <class S>
MUROSIMF_INLINE void articulatedOutward(const ArticulatedTree& tree, const ArticulatedBody<S>& c) {
  accelerateOutward(tree, c.tree, [&](int i, const SpatialMotion<S>& a) MUROSIMF_INLINE_LAMBDA {
    const JointResponse<S>& response = c.response[i - 1];
    return response.u_over_D - dot(a, response.U_over_D);
  });
}

template <class S>
MUROSIMF_INLINE void articulatedBody(const ArticulatedTree& tree, const ArticulatedBody<S>& c) {
  articulatedInward(tree, c, [](int, ArticulatedInertia<S>&, SpatialForce<S>&) {});
  articulatedOutward(tree, c);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
