#pragma once

/// @file Simplified dynamics of a robot: its joints move as prescribed, whatever that takes; its base moves by the laws
/// of mechanics.
///
/// Model      [Friedmann 2007, 3.3.1], in two versions by the parameter `recompute`.
///            1 (version 2)  Centre of mass and inertia follow from the bodies' masses at every step, and limbs react:
///                           the motion is that of full multibody dynamics with perfect servos. Equations:
///                           algorithms/composite_motion.h, algorithms/centroidal_motion.h.
///            0 (version 1)  Centre of mass and inertia are those of the joints' first positions, fixed to the base:
///                           limbs are shells without mass that touch the ground.
///            What contacts add for steps that look ahead is one inertia at the base (algorithms/ground_fold.h), so
///            stiff grounds are stable in long steps. The base's acceleration A solves
///                (Ic + K) A = W - (change of Ic V + g by the joints' motion) / h - V x* (Ic V + g).
/// State      joint_position, joint_velocity, base_pose, base_velocity, as with all motion modules; the momentum is
///            formed from them. composite_motion is what the step before has found, checked, and found again where
///            somebody has moved joints in between.
/// Limits     Sines at the end of a step are exact for joints that turn by up to pi/4 in it; beyond that inertia and
///            momentum are off.
/// Phase      kEvaluate: the integrator momentum_midpoint asks for it.
/// Needs      the tree, body_inertia of the bodies; initial_position for version 1.
/// Adds       base_acceleration, proper, in base axes about its origin; centroidal_step for the integrator.
/// Cost       version 2: about 100 operations a joint, 300 a body that touches the ground, 500 for the base.

#include "murosimf/linking/module.h"
#include "murosimf/modules/dynamics/simplified_dynamics_kernel.h"

namespace murosimf {

class SimplifiedDynamics final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  explicit SimplifiedDynamics(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  /// Nothing is known ahead: a position that equals none says so.
  void initialise(const BlockMemory& block) const override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  GatherPlan gather_;
  SimplifiedArguments arguments_;
  int width_ = 1;
  KernelSet<SimplifiedArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
