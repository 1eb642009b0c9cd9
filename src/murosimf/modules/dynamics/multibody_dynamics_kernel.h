#pragma once

/// @file Kernel of multibody_dynamics.h.

#include "murosimf/algorithms/articulated_body.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct MultibodyArguments {
  ArticulatedTree tree;
  ColumnRef turn, dq, torque, joint_inertia, armature, damping, inertia, twist, force;
  ColumnRef acceleration, joint_acceleration, response, slot_inertia, slot_bias;
  bool contacts = false;  ///< whether something may add inertia at contacts
  ColumnRef contact_touch, contact_inertia;
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
  const ArticulatedBody<S> columns{columnAt<SinCos<S>, S>(block, a.turn),
                                   dq,
                                   torque,
                                   inertia,
                                   columnAt<RigidInertia<S>, S>(block, a.inertia),
                                   columnAt<SpatialMotion<S>, S>(block, a.twist),
                                   columnAt<SpatialForce<S>, S>(block, a.force),
                                   columnAt<SpatialMotion<S>, S>(block, a.acceleration),
                                   columnAt<S, S>(block, a.joint_acceleration),
                                   columnAt<JointResponse<S>, S>(block, a.response),
                                   columnAt<ArticulatedInertia<S>, S>(block, a.slot_inertia),
                                   columnAt<SpatialForce<S>, S>(block, a.slot_bias)};
  const S* touch = columnAt<S, S>(block, a.contact_touch);
  articulatedInward(a.tree, columns, [&](int i, ArticulatedInertia<S>& IA, SpatialForce<S>&) MUROSIMF_INLINE_LAMBDA {
    const auto touches = touch[i] > S(0);
    if (a.contacts && any(touches)) [[unlikely]] {
      ArticulatedInertia<S> with = IA;
      with += columnAt<ArticulatedInertia<S>, S>(block, a.contact_inertia)[i];
      IA = select(touches, with, IA);
    }
  });
  articulatedOutward(a.tree, columns);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
