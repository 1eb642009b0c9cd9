#pragma once

/// @file The integrator of simplified dynamics: steps momentum, which free flight keeps to rounding.
///
/// Model      algorithms/centroidal_motion.h, and q+ = q + h dq+ with dq+ the rates that joint_rate_demand holds over
///            the step. Forces look ahead to the end of the step, as in implicit_euler: stiff grounds are stable.
/// Order      2 in free flight while joints rest or bodies turn about axes of symmetry, else 1.
/// Adds       joint_position, joint_velocity, base_pose, base_velocity; step_manner.
/// Cost       one evaluation, about 300 operations for the base and 3 a joint.

#include "murosimf/linking/fixed_value.h"
#include "murosimf/linking/integrator.h"
#include "murosimf/modules/integration/momentum_midpoint_kernel.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class MomentumMidpoint final : public Integrator {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override { manner_.adopt(one); }
  void step(const BlockMemory& block, const StepTime& time) const override;

 private:
  MomentumMidpointArguments arguments_;
  FixedValue<StepManner> manner_{kStepManner, {0.5, 0}};
  ColumnRef initial_;
  int width_ = 1;
  KernelSet<MomentumMidpointArguments>::Kernel advance_ = nullptr;
};

}  // namespace murosimf
