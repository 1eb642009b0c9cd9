#pragma once

/// @file The electronics of position servos: turns commands into what the motors are to do, once a step.
///
/// Model      A joint whose command has kp > 0 is held by its servo's own gains kp and kd at the commanded position,
///            within the joint's range. Where the command has a velocity > 0, the position held moves there at that
///            speed, from where it was, or from the joint's position when the servo was off. kp = 0: the servo is off.
///            The command's torque is added.
/// Options, as parameters
///            commanded_gains  the command's own kp, kd and velocity hold: tau = kp (position - q) + kd (velocity - dq)
///                             + torque, as today's humanoids have it; any position, no speed limit.
///            encoder_steps    the position is known in steps r = encoder_resolution: the error is that of r round(q/r)
///                             at the beginning of the step, and moves on with the joint within it.
///            delay_steps      commands act that many steps later, as after a slow bus; until the first has come,
///            servos
///                             are off.
/// Phase      kPrescribe: before forces are evaluated, however often that happens.
/// Adds       servo_demand: position, torque, kp, kd as they hold during the step; velocity 0.
/// Cost       about 10 operations a joint.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/servo_controller_kernel.h"

namespace murosimf {

class ServoController final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  /// @throws std::invalid_argument when a switch is neither 0 nor 1, or a number of steps is not whole.
  explicit ServoController(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  ServoControllerArguments arguments_;
  KernelSet<ServoControllerArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
