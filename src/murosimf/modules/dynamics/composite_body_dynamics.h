#pragma once

/// @file Full multibody dynamics of a robot by its mass matrix: the other way to the accelerations of
/// multibody_dynamics.h.
///
/// Model      algorithms/composite_body.h with gravity, the sums of joint torques and of forces on bodies, the rotors'
///            inertia and viscous friction -joint_damping dq, which implicit steps take at their end.
/// Phase      kEvaluate: an integrator asks for it.
/// Needs      the tree, body_inertia of the bodies; armature and joint_damping of joints count as 0 where missing.
/// Adds to    joint_torque, joint_inertia: friction and rotors.
/// Adds       joint_acceleration; body_acceleration, proper, in each body's axes about its origin.
/// Errors     a tree so deep that its matrix does not fit: more than about 40 joints on the way to a body, on average.
/// Exchange   with multibody_dynamics: same accelerations but for rounding.

#include "murosimf/modules/dynamics/composite_body_dynamics_kernel.h"
#include "murosimf/modules/dynamics/full_dynamics.h"

namespace murosimf {

class CompositeBodyDynamics final : public FullDynamics {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  MassMatrixPlan plan_;
  CompositeBodyArguments arguments_;
  KernelSet<CompositeBodyArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
