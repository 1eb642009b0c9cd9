#pragma once

/// @file Accelerations of all bodies of a robot whose joints move as prescribed, for sensors and torque_estimate.
///
/// Model      outward from the base, A = X A_P + V x S dq + S ddq, ddq = (joint_rate_demand - dq) / dt.
/// Phase      kEvaluate, behind simplified_dynamics. Runs only if somebody reads what it adds.
/// Adds       joint_acceleration; body_acceleration, proper, in each body's axes about its origin.
/// Cost       about 30 operations a joint.

#include "murosimf/linking/module.h"
#include "murosimf/modules/dynamics/body_accelerations_kernel.h"

namespace murosimf {

class BodyAccelerations final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  BodyAccelerationsArguments arguments_;
  KernelSet<BodyAccelerationsArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
