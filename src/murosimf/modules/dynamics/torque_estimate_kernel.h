#pragma once

/// @file Kernel of torque_estimate.h.

#include "murosimf/algorithms/inverse_dynamics.h"
#include "murosimf/algorithms/solved_force.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct TorqueEstimateArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  ColumnRef turn, dq, ddq, armature, damping, stall_torque, inertia, twist, acceleration, force;
  bool contacts = false;  ///< whether something may add inertia at contacts
  ColumnRef contact_touch, contact_inertia, met, transmitted, torque, load;
};

void addBaselineKernels(KernelSet<TorqueEstimateArguments>& kernels);
void addWideKernels(KernelSet<TorqueEstimateArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// The forces on all bodies, of contacts what came of them.
template <class S>
inline void meetForces(const TorqueEstimateArguments& a, const BlockMemory& block, SpatialForce<S>* met) {
  const auto* force = columnAt<SpatialForce<S>, S>(block, a.force);
  const auto* acceleration = columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  const S* touch = columnAt<S, S>(block, a.contact_touch);
  for (int i = 0; i < a.bodies; ++i) {
    met[i] = force[i];
    const auto touches = touch[i] > S(0);
    if (!a.contacts || !any(touches)) continue;
    met[i] = solvedForce(force[i], touches, columnAt<ArticulatedInertia<S>, S>(block, a.contact_inertia)[i],
                         acceleration[i]);
  }
}

template <class S>
void torqueEstimate(const TorqueEstimateArguments& a, const BlockMemory& block, const StepTime&) {
  auto* met = columnAt<SpatialForce<S>, S>(block, a.met);
  meetForces(a, block, met);
  const S* dq = columnAt<S, S>(block, a.dq);
  S* torque = columnAt<S, S>(block, a.torque);
  findJointForces(a.rows, a.bodies,
                  JointForces<S>{columnAt<SinCos<S>, S>(block, a.turn), columnAt<S, S>(block, a.ddq),
                                 columnAt<S, S>(block, a.armature), columnAt<RigidInertia<S>, S>(block, a.inertia),
                                 columnAt<SpatialMotion<S>, S>(block, a.twist),
                                 columnAt<SpatialMotion<S>, S>(block, a.acceleration), met, torque,
                                 columnAt<SpatialForce<S>, S>(block, a.transmitted)});
  const S *damping = columnAt<S, S>(block, a.damping), *stall = columnAt<S, S>(block, a.stall_torque);
  S* load = columnAt<S, S>(block, a.load);
  for (int j = 0; j + 1 < a.bodies; ++j) {
    torque[j] = fma(damping[j], dq[j], torque[j]);
    load[j] = abs(torque[j]) / stall[j];
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
