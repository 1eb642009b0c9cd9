#pragma once

/// @file Inverse dynamics: the joint torques of a given motion, by recursive Newton-Euler [Featherstone 2008, 5.3].
///
/// Outward a = X a_P + S ddq + c, then inward  f = I a + V x* I V - f_ext,  tau = S^T f + d ddq,  f_P += X^T f.
/// What is left at the base is the force that somebody would have to push it with; 0 for a floating base that moves
/// freely. Signs, frames and proper accelerations as in articulated_body.h. Cost: about 150 multiplications a joint.

#include "murosimf/algorithms/joint_bias.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Columns, one element a body unless said.
template <class S>
struct InverseDynamics {
  const SinCos<S>* turn = nullptr;        ///< of each joint
  const S* joint_velocity = nullptr;      ///< of each joint
  const S* joint_acceleration = nullptr;  ///< of each joint
  const S* joint_inertia = nullptr;       ///< of each joint: d
  const RigidInertia<S>* inertia = nullptr;
  const SpatialMotion<S>* velocity = nullptr;
  const SpatialForce<S>* force = nullptr;    ///< f_ext
  SpatialMotion<S>* acceleration = nullptr;  ///< element 0 is given, the rest results
  S* joint_torque = nullptr;                 ///< result, of each joint
  SpatialForce<S>* transmitted = nullptr;    ///< result: from the parent; element 0: needed at the base
};

template <class S>
inline void inverseDynamics(const KernelRow* rows, int bodies, const InverseDynamics<S>& c) {
  for (int i = 0; i < bodies; ++i) {
    if (i > 0) {
      forJoint<S>(rows[i], c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
        SpatialMotion<S> a = joint.into(c.acceleration[rows[i].parent]);
        add(a, jointBias<decltype(joint)>(c.velocity[i], c.joint_velocity[i - 1]));
        joint.add(a, c.joint_acceleration[i - 1]);
        c.acceleration[i] = a;
      });
    }
    const SpatialForce<S> momentum = c.inertia[i] * c.velocity[i];
    c.transmitted[i] = c.inertia[i] * c.acceleration[i] + cross(c.velocity[i], momentum) - c.force[i];
  }
  for (int i = bodies - 1; i > 0; --i) {
    forJoint<S>(rows[i], c.turn[i - 1], [&](auto joint) MUROSIMF_INLINE_LAMBDA {
      c.joint_torque[i - 1] = fma(c.joint_inertia[i - 1], c.joint_acceleration[i - 1], joint.along(c.transmitted[i]));
      c.transmitted[rows[i].parent] += joint.outOf(c.transmitted[i]);
    });
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
