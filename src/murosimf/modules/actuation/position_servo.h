#pragma once

/// @file Position servos with the limits of their motors.
///
/// Model      tau = kp (position - q) - kd dq + torque, of servo_demand, within the motor's torque-speed line: at most
///            stall_torque (1 - dq/no_load_speed) forward and stall_torque (1 + dq/no_load_speed) backward, and never
///            more than stall_torque, also while something else turns the motor.
///            For a step h that looks ahead q and dq are those at its end, q + h (dq + h ddq) and dq + h ddq; what
///            depends on ddq counts as inertia h kd + h^2 kp at the joint, so gains of any size are stable. A joint at
///            its limit pushes with that limit.
/// Play       backlash of the joint: gear_play.h.
/// Phase      kEvaluate.
/// Adds to    joint_torque, joint_inertia.
/// Cost       about 20 operations a joint.
/// Exchange   with any other module that drives joints.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/position_servo_kernel.h"

namespace murosimf {

class PositionServo final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  PositionServoArguments arguments_;
  KernelSet<PositionServoArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
