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
/// Cost       a frame of a humanoid of 21 joints that stands: 1.3 times that with multibody_dynamics; grows with joints
///            times depth, for chains that fly from 1.15 times with 3 joints to 6 times with 48 (docs/performance.md).
/// Exchange   with multibody_dynamics: same accelerations but for rounding.
///
/// Which one: multibody_dynamics, whatever the robot; it is faster from the first joints on. This one is the second
/// opinion where accelerations are doubted; the mass matrix itself is what algorithms/composite_body.h is for.

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
