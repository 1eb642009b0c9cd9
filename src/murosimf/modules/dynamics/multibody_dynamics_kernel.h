#pragma once

/// @file Kernel of multibody_dynamics.h.

#include "murosimf/algorithms/articulated_body.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct MultibodyArguments {
  ArticulatedTree tree;
  ColumnRef turn, dq, torque, joint_inertia, armature, damping, inertia, twist, force;
  ColumnRef acceleration, joint_acceleration, response, slot_inertia, slot_bias;
};

void addBaselineKernels(KernelSet<MultibodyArguments>& kernels);
void addWideKernels(KernelSet<MultibodyArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void multibodyDynamics(const MultibodyArguments& a, const BlockMemory& block, const StepTime& time) {
  const S* dq = columnAt<S, S>(block, a.dq);
  S* torque = columnAt<S, S>(block, a.torque);
  S* inertia = columnAt<S, S>(block, a.joint_inertia);
  const S *armature = columnAt<S, S>(block, a.armature), *damping = columnAt<S, S>(block, a.damping);
  for (int j = 0; j + 1 < a.tree.bodies; ++j) {  // viscous friction, -b (dq + h ddq)
    torque[j] = fnma(damping[j], dq[j], torque[j]);
    inertia[j] += fma(S(time.implicit), damping[j], armature[j]);
  }
  articulatedBody(
      a.tree,
      ArticulatedBody<S>{
          columnAt<SinCos<S>, S>(block, a.turn), dq, torque, inertia, columnAt<RigidInertia<S>, S>(block, a.inertia),
          columnAt<SpatialMotion<S>, S>(block, a.twist), columnAt<SpatialForce<S>, S>(block, a.force),
          columnAt<SpatialMotion<S>, S>(block, a.acceleration), columnAt<S, S>(block, a.joint_acceleration),
          columnAt<JointResponse<S>, S>(block, a.response), columnAt<ArticulatedInertia<S>, S>(block, a.slot_inertia),
          columnAt<SpatialForce<S>, S>(block, a.slot_bias)});
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
