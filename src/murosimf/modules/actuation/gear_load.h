#pragma once

/// @file What loads the gears of the servos: the torque from outside that each carries.
///
/// Model      gear_load = (armature + d) ddq - tau, with tau + (-d ddq) what the motor and the gear's friction put on
/// the
///            joint in the last evaluation: all that is left of the joint's motion is the link's doing. At rest and at
///            constant speed this is the weight and the contacts that the joint bears, with their sign; else the link's
///            own inertia is in it, since the gear's teeth move that too.
/// Phase      kAdvance, behind the integrator: the next step's friction reads it (readsLast), so that nothing is solved
///            in a circle.
/// Adds       gear_load.
/// Cost       3 operations a joint.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/gear_load_kernel.h"

namespace murosimf {

class GearLoad final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  GearLoadArguments arguments_;
  KernelSet<GearLoadArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
