#pragma once

/// @file Kinematic walking: the stance foot is pinned to the ground, and the joints carry the rest of the robot.
///
/// State      which foot stands (1 bit) and where its sole is in the ground plane: anchor (x, y, heading). Height, roll
///            and pitch of the stance sole are never integrated, so they cannot drift.
/// Model      X_WS = Trans(x, y, 0) RotZ(heading);  X_WB = X_WS X_BS(q)^-1;  c(q) = height of the lowest corner of
///            the swing sole over the plane. When c reaches 0 inside a step the feet exchange their roles there:
///            u with c(q(u)) = 0 on the straight path from the last q to this one is searched, the swing
///            sole's pose at q(u) with height, roll and pitch dropped becomes the anchor, and the step goes on from
///            it. Without the search each foothold would be off by up to (foot speed) dt. [Friedmann 2007, 3.2]
/// Hysteresis An exchange needs c <= 0 after c > eps since the last one, or a foot that goes eps deeper than it was
///            after the last one: two soles that stay on the ground do not change roles every step, nor do two that are
///            not parallel, of which the one that does not stand is always a little below the ground.
/// Residual   What dropping height, roll and pitch takes away at an exchange is shown on and faded out over
///            `blend_time`; with soles parallel at touch-down it is zero to rounding.
/// Placement  A new placement_count puts the base at `placement` (x, y, heading); the lower foot stands.
/// Adoption   A robot that comes from another level of detail goes on with its lower foot where that is, flat; what
///            flattening takes away is a residual too.
/// Blocking   planar_shift of the step before moves the anchor: robots that got too near are kept apart.
/// Reports    flattened_turn, flattened_shift: sizes of the last residual. support_slip: speed of the other
///            sole while both touch. flight: 1 where the base falls faster than g, so that a real robot would leave the
///            ground; here the stance sole stays pinned.
/// Limits     ground z = 0. The robot never falls and nothing pushes it. Lying, sitting and jumping are outside.
/// Cost       two chains of sines and rotations from the base to the soles; about 5 times that more at a touch-down.
/// Exchange   with any module that adds base_pose.

#include "murosimf/linking/module.h"
#include "murosimf/modules/motion/kinematic_walking_kernel.h"

namespace murosimf {

class KinematicWalking final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  explicit KinematicWalking(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override { adoptStance(arguments_, one); }
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  KinematicWalkingArguments arguments_;
  int width_ = 1;
  KernelSet<KinematicWalkingArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
