#pragma once

/// @file What kernels of full multibody dynamics share: their columns, friction and rotors of joints, contacts.

#include "murosimf/algorithms/tree_dynamics.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct FullDynamicsArguments {
  ArticulatedTree tree;
  ColumnRef turn, dq, torque, joint_inertia, armature, damping, inertia, twist, force;
  ColumnRef acceleration, joint_acceleration, slot_inertia, slot_bias;
  bool contacts = false;  ///< whether something may add inertia at contacts
  ColumnRef contact_touch, contact_inertia;
};

inline namespace MUROSIMF_ISA {

template <class S>
MUROSIMF_INLINE TreeDynamics<S> treeColumns(const FullDynamicsArguments& a, const BlockMemory& block) {
  return {columnAt<SinCos<S>, S>(block, a.turn),
          columnAt<S, S>(block, a.dq),
          columnAt<S, S>(block, a.torque),
          columnAt<S, S>(block, a.joint_inertia),
          columnAt<RigidInertia<S>, S>(block, a.inertia),
          columnAt<SpatialMotion<S>, S>(block, a.twist),
          columnAt<SpatialForce<S>, S>(block, a.force),
          columnAt<SpatialMotion<S>, S>(block, a.acceleration),
          columnAt<S, S>(block, a.joint_acceleration),
          columnAt<ArticulatedInertia<S>, S>(block, a.slot_inertia),
          columnAt<SpatialForce<S>, S>(block, a.slot_bias)};
}

/// Adds the joints' viscous friction, -b (dq + h ddq), and their rotors to the sums.
template <class S>
MUROSIMF_INLINE void addJointLoads(const FullDynamicsArguments& a, const BlockMemory& block, const StepTime& time) {
  const S* dq = columnAt<S, S>(block, a.dq);
  S* torque = columnAt<S, S>(block, a.torque);
  S* inertia = columnAt<S, S>(block, a.joint_inertia);
  const S *armature = columnAt<S, S>(block, a.armature), *damping = columnAt<S, S>(block, a.damping);
  for (int j = 0; j + 1 < a.tree.bodies; ++j) {
    torque[j] = fnma(damping[j], dq[j], torque[j]);
    inertia[j] += fma(S(time.implicit), damping[j], armature[j]);
  }
}

/// What contacts add to the inertia of a body: for the `fold` of the ways inward.
template <class S>
struct ContactFold {
  const S* touch;
  const ArticulatedInertia<S>* inertia;  ///< null: nothing adds any

  ContactFold(const FullDynamicsArguments& a, const BlockMemory& block)
      : touch(columnAt<S, S>(block, a.contact_touch)),
        inertia(a.contacts ? columnAt<ArticulatedInertia<S>, S>(block, a.contact_inertia) : nullptr) {}

  MUROSIMF_INLINE void operator()(int i, ArticulatedInertia<S>& Ic, SpatialForce<S>&) const {
    const auto touches = touch[i] > S(0);
    if (inertia != nullptr && any(touches)) [[unlikely]] {
      ArticulatedInertia<S> with = Ic;
      with += inertia[i];
      Ic = select(touches, with, Ic);
    }
  }
};

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
