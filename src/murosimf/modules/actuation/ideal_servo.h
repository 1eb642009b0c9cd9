#pragma once

/// @file Servos that reach any position within their range at their no-load speed, whatever the load.
///
/// Model      q+ = q + clamp(clamp(q_cmd, lower, upper) - q, +-v_max dt),  v = (q+ - q)/dt.
///            v_max is the servo's no-load speed, or the command's own speed limit where that is smaller and positive.
///            A command with kp = 0 asks for nothing: the joint stays where it is; one with kp = 0 and kd > 0 asks for
///            its velocity, as wheels are driven.
/// Cost       about 10 operations a joint.
/// Exchange   with any module that adds joint_position and joint_velocity.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/ideal_servo_kernel.h"

namespace murosimf {

class IdealServo final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  IdealServoArguments arguments_;
  ColumnRef initial_;
  int width_ = 1;
  KernelSet<IdealServoArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
