#pragma once

/// @file Force sensors in three axes: with what force all that hangs on a joint presses on what carries it.
///
/// Model      f = sum over the bodies beyond of (contact forces - rate of momentum, gravity counted with it), turned
/// into
///            the sensor's axes:  -f = sum R_i (m a_C - f_i),  a_C the proper acceleration of a body's centre of mass
///            and f_i the solved forces on it. At rest a foot reads the ground's push less its own weight; in the air,
///            held still, its weight downward; in free fall nothing.
/// Phase      kEvaluate, behind the dynamics: with several evaluations a step the last one counts.
/// Needs      the tree, body_inertia; force_place of the force sensors: M on the body that a joint moves.
/// Adds       sensed_force of each force sensor.
/// Errors     a force sensor on the base, which hangs on nothing.
/// Cost       40 operations a body beyond a sensor, 60 more where it touches the ground.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/force_sensor_kernel.h"

namespace murosimf {

class ForceSensor final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  void findBodiesBeyond();
  std::vector<KernelRow> rows_;
  std::vector<ForceSensorPlace> places_;
  std::vector<BodyBeyond> beyond_;
  ForceSensorArguments arguments_;
  KernelSet<ForceSensorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
