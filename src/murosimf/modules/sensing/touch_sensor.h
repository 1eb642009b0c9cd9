#pragma once

/// @file Touch sensors: whether something presses on the shapes of a link, as a bumper or a switch under a foot tells.
///
/// Model      touch_force = sum of the ground's normal forces on the shapes of the sensor's link, the solved ones, and
///            of push_force, what free bodies do to them in this frame; the sensor is closed (1) where it is above
///            touch_threshold, else open (0). Links that are fixed to one another are told apart: a plate fixed to the
///            trunk feels what touches the plate.
/// Phase      kEvaluate, behind the dynamics: with several evaluations a step the last one counts.
/// Needs      touch_threshold of the touch sensors; shapes that say which sensor feels them (PlacedShape).
/// Adds       touch_force, touch of each touch sensor.
/// Errors     a touch sensor that no shape belongs to.
/// Limits     Ground and free bodies (the ball) are felt, not posts and other robots.
/// Cost       15 operations a sensor, and in the ground contact 60 a shape of one that touches.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/touch_sensor_kernel.h"

namespace murosimf {

class TouchSensor final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<int> rows_;  // of each sensor
  TouchSensorArguments arguments_;
  KernelSet<TouchSensorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
