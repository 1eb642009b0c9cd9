#pragma once

/// @file tree_motion for robots with simplified dynamics, at half the cost.
///
/// Model      that of tree_motion.h. Sines and cosines come from simplified_dynamics, which has turned them ahead to
/// the
///            end of its last step; where somebody has moved joints since, and every 1024 frames, they are found anew.
/// Phase      kEvaluate.
/// Adds       joint_turn; body_twist, body_up, body_height; joints_kept, for simplified_dynamics.
/// Cost       about 30 operations a joint.
/// Exchange   with tree_motion.

#include "murosimf/linking/module.h"
#include "murosimf/modules/dynamics/prescribed_tree_motion_kernel.h"

namespace murosimf {

class PrescribedTreeMotion final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  VisitPlan visits_;
  PrescribedTreeMotionArguments arguments_;
  KernelSet<PrescribedTreeMotionArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
