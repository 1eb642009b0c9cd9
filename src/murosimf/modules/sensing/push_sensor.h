#pragma once

/// @file Touch sensors of motions that know no forces of the ground: what can push is felt, the ground is not.
///
/// Model      touch_force = push_force, with which balls, other robots and posts press on the shapes of the sensor's
/// link
///            (pair_phase.h); the sensor is closed (1) where it is above touch_threshold, else open (0).
/// Phase      kSense, at the rate of the motion: a slower one looks at the frame that ended last alone.
/// Needs      touch_threshold of the touch sensors.
/// Adds       touch_force, touch of each touch sensor.
/// Limits     What kinematic robots are kept apart from by blocking_radius never touches them.
/// Cost       a comparison a sensor.
/// Exchange   with touch_sensor, which feels the ground too.

#include "murosimf/linking/robot_module.h"

namespace murosimf {

class PushSensor final : public RobotModule {
 public:
  void declare(Declaration& declaration) const override;

 private:
  void bind(Links& links) override;
  void stepRobot(const RobotLane& robot, const StepTime& time) const override;

  RobotValues<const double> threshold_;
  RobotValues<double> push_, force_, touch_;
};

}  // namespace murosimf
