#pragma once

/// @file How all bodies of a robot move, in their own axes: what servos, ground contact and dynamics start from.
///
/// Model      algorithms/tree_motion.h, from joint positions and rates and the base's pose and velocity, O(bodies).
/// Phase      kEvaluate.
/// Adds       joint_turn; body_twist, body_up, body_height.
/// Cost       a sine and cosine a joint, two turns about an axis and a cross product a body.

#include "murosimf/linking/module.h"
#include "murosimf/modules/dynamics/tree_motion_kernel.h"

namespace murosimf {

class TreeMotionPass final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  TreeMotionArguments arguments_;
  KernelSet<TreeMotionArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
