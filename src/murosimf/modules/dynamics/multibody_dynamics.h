#pragma once

/// @file Full multibody dynamics of a robot: every body has its mass, every joint its torque.
///
/// Model      algorithms/articulated_body.h with gravity, the sums of joint torques and of forces on bodies, the
///            rotors' inertia and viscous friction -joint_damping dq, which implicit steps take at their end.
/// Phase      kEvaluate: an integrator asks for it.
/// Needs      the tree, body_inertia of the bodies; armature and joint_damping of joints count as 0 where missing.
/// Adds to    joint_torque, joint_inertia: friction and rotors.
/// Adds       joint_acceleration; body_acceleration, proper, in each body's axes about its origin.
/// Cost       about 380 multiplications and additions a joint.
/// Exchange   with any module that adds these two; composite_body_dynamics finds the same accelerations.

#include "murosimf/modules/dynamics/full_dynamics.h"
#include "murosimf/modules/dynamics/multibody_dynamics_kernel.h"

namespace murosimf {

class MultibodyDynamics final : public FullDynamics {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  MultibodyArguments arguments_;
  KernelSet<MultibodyArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
