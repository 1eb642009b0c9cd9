#pragma once

/// @file The torque that each servo would have needed for what simplified dynamics let it do: shows who is overloaded.
///
/// Model      algorithms/inverse_dynamics.h with the step's accelerations and contact forces, the rotors' inertia and
///            viscous friction: tau = S^T f + armature ddq + joint_damping dq. A rate that jumps takes the torque that
///            makes it jump within one step.
/// Phase      kEvaluate, behind the accelerations. Runs only if somebody reads what it adds.
/// Needs      stall_torque of the joints; armature and joint_damping count as 0 where missing.
/// Adds       measured_torque; servo_load, its size over stall_torque.
/// Cost       about 160 operations a joint.

#include "murosimf/linking/module.h"
#include "murosimf/modules/dynamics/torque_estimate_kernel.h"

namespace murosimf {

class TorqueEstimate final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  TorqueEstimateArguments arguments_;
  KernelSet<TorqueEstimateArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
