#pragma once

/// @file How a robot takes the forces of other robots, balls and posts: it recoils.
///
/// Model      what the pair phase has found for the frame is held over it as a force and a moment on each body, both
///            constant in the body's axes; the pair phase turns it so that its mean over the step is right in the
///            world's (held_turn of step_manner). A robot without this module goes on as if it had touched nothing.
///            pair_forces        joints give way: for multibody dynamics
///            rigid_pair_forces  the robot answers as one body whose joints are held: for simplified dynamics. With
///                               joints that do give way it would promise more mass than the robot has, and throw what
///                               it touches.
/// Phase      kEvaluate, before the dynamics.
/// Adds       pair_force, which the pair phase writes; pair_touch; joints_yield, which says which of the two it is.
/// Adds to    body_force.
/// Cost       6 additions a body where something touches a robot of the block, else nothing.

#include "murosimf/linking/fixed_value.h"
#include "murosimf/modules/contact/pair_forces_kernel.h"

namespace murosimf {

class PairForces : public BlockModule {
 public:
  PairForces() : PairForces(true) {}
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override { joints_yield_.initialise(block); }
  void adopt(const BlockMemory& one) const override { joints_yield_.adopt(one); }
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 protected:
  explicit PairForces(bool joints_yield);

 private:
  FixedValue<double> joints_yield_;
  PairForcesArguments arguments_;
  KernelSet<PairForcesArguments>::Kernel kernel_ = nullptr;
};

class RigidPairForces final : public PairForces {
 public:
  RigidPairForces() : PairForces(false) {}
};

}  // namespace murosimf
