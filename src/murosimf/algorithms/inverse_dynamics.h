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

/// What the way inward needs of it, and gives.
template <class S>
struct JointForces {
  const SinCos<S>* turn = nullptr;
  const S *joint_acceleration = nullptr, *joint_inertia = nullptr;
  const RigidInertia<S>* inertia = nullptr;
  const SpatialMotion<S>*velocity = nullptr, *acceleration = nullptr;
  const SpatialForce<S>* force = nullptr;
  S* joint_torque = nullptr;
  SpatialForce<S>* transmitted = nullptr;
};

/// Inward, where all accelerations are known.
template <class S>
inline void findJointForces(const KernelRow* rows, int bodies, const JointForces<S>& c) {
  for (int i = 0; i < bodies; ++i) {
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

template <class S>
inline void inverseDynamics(const KernelRow* rows, int bodies, const InverseDynamics<S>& c) {
  for (int i = 1; i < bodies; ++i) {
    c.acceleration[i] = childAcceleration(rows[i], c.acceleration[rows[i].parent], c.turn[i - 1], c.velocity[i],
                                          c.joint_velocity[i - 1], c.joint_acceleration[i - 1]);
  }
  findJointForces(rows, bodies,
                  JointForces<S>{c.turn, c.joint_acceleration, c.joint_inertia, c.inertia, c.velocity, c.acceleration,
                                 c.force, c.joint_torque, c.transmitted});
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
