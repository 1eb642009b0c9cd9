#pragma once

/// @file World poses of all bodies of a robot, for those who look at it: cameras, contacts, pictures.
///
/// Model      X_WB(child) = X_WB(parent) X_PF J(q), from the base outwards, O(bodies).
/// Phase      that of the module that adds base_pose, behind it, at its rate. Runs only when somebody reads body_pose.
/// Adds       the posture at both ends of a step, and on demand body_pose and body_pose_last of the bodies: of a
///            thousand robots few are looked at in a frame. Between the two ends of a step a body is taken to move on
///            the straight path from one to the other. After a placement both ends are the new pose.
/// Cost       a copy of joint positions and base pose; when asked a rotation about an axis and a transformed point a
///            body, and as much again where the step before was not asked for.

#include "murosimf/linking/module.h"
#include "murosimf/modules/kinematics/body_poses_kernel.h"

namespace murosimf {

class BodyPoses final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void step(const BlockMemory& block, const StepTime& time) const override { keep_(posture_, block, time); }
  void answer(const BlockMemory& block) const override { compute_(arguments_, block, {}); }

 private:
  std::vector<KernelRow> rows_;
  PostureArguments posture_;
  BodyPosesArguments arguments_;
  int width_ = 1;
  KernelSet<PostureArguments>::Kernel keep_ = nullptr;
  KernelSet<BodyPosesArguments>::Kernel compute_ = nullptr;
};

}  // namespace murosimf
