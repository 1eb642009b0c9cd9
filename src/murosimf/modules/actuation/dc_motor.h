#pragma once

/// @file Servos with a direct-current motor: position controller, voltage, current, and the friction of the gear.
///
/// Controller V = error_gain firmware_kp U (position - q) + R/k torque, of servo_demand; U: supply_voltage, k:
///            torque_constant, R: motor_resistance, all seen at the joint. A servo that is switched off (kp = 0) lets
///            as much current through as its torque asks for: V = k dq + R/k torque.
/// Bounds     The firmware keeps the current within largest_current as far as the voltage allows it, then |V| within
///            largest_duty U.
/// Motor      I = (V - k dq)/R,   tau = k I: stall torque k U largest_duty/R, no-load speed U largest_duty/k.
/// Gear       friction algorithms/gear_friction.h with tau, the gear_load of the step before and dq, as dry_friction.h
///            puts it on the joint, and -friction_viscous dq. The joint's armature is the rotor's inertia.
///            [Duclusaud et al. 2025]; parameters as their program `bam` identifies them.
/// Play       backlash of the joint: gear_play.h. Within it nothing of motor and gear reaches the joint.
/// Looks ahead For a step h, q and dq are those at its end, q + h (dq + h ddq) and dq + h ddq; what depends on ddq
///            counts as inertia at the joint: h k^2/R of the back EMF, h^2 k/R error_gain firmware_kp U of the
///            controller where no limit holds it, and friction's.
/// Limits     The supply does not sag, the winding neither heats nor has an inductance. Which bound holds is told from
///            q + h dq: a light joint whose controller turns its voltage over within a step hunts, seen from 20/rad at
///            20 ms on, not at 10 ms up to 100/rad (servos have about 5/rad).
/// Phase      kEvaluate.
/// Adds to    joint_torque, joint_inertia.  Adds motor_torque, motor_inertia: its own share of them.
/// Cost       about 60 operations a joint; an exponential and a power more for friction with a Stribeck effect.
/// Exchange   with position_servo.

#include "murosimf/linking/module.h"
#include "murosimf/modules/actuation/dc_motor_kernel.h"

namespace murosimf {

class DcMotor final : public BlockModule {
 public:
  static std::vector<ParameterInfo> parameters();
  /// @throws std::invalid_argument when friction_model is no whole number.
  explicit DcMotor(const ParameterValues& values);
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  DcMotorArguments arguments_;
  KernelSet<DcMotorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
