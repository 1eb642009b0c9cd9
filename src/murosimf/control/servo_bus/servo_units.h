#pragma once

/// @file From a servo's registers to SI units, and back.
///
/// Position   4096 steps a turn, 2048 in the middle.
/// Torque     A motor with the share u of its voltage gives tau = T (u - w/w0), T stall torque, w0 no-load speed, both
///            at the voltage of the supply: they go with it. Current: tau = (T/I) i, I the stall current.
/// P gain     2.0: the share per error e in steps is (P/128) e / 885, the constant part of the manual's controller
///            divided by the largest PWM. So kp = T (P/128) (4096/2 pi)/885.
///            1.0: the manual gives P/8 without a unit; 0.158 P a radian was measured at MX-64 and MX-106 [Duclusaud et
///            al. 2025, program `bam`]. So kp = 0.158 P T. With their first values, 32 and 850, both are the same
///            servo: 5.06 T and 4.89 T.
/// D gain     2.0: (D/16) times what the error grows in a period of the controller; the manual gives no period, taken
///            is 1 ms. 1.0: the manual's Kd/Kp = (D 4/1000)/(P/8), in seconds. Against the motor's own speed works the
///            voltage that it induces as well, kd = T/w0.
/// I gain and feedforward gains have no part in it.
/// Source     ROBOTIS e-Manual, "PID gain", "Position PID Gain", "Profile Velocity" of the servos' pages.

#include "murosimf/control/servo_bus/control_table.h"

namespace murosimf::servo_bus {

/// A servo at its supply voltage.
struct ServoScale {
  double stall_torque = 0;     ///< [N m]
  double no_load_speed = 0;    ///< [rad/s]
  double torque_constant = 0;  ///< [N m/A]
  double velocity_unit = 0;    ///< [rad/s]
  double current_unit = 0;     ///< [A]; 0: none
  bool old = false;            ///< of version 1.0
};
ServoScale scaleOf(const ControlTable& table, double supply_voltage);

inline constexpr double kStepsPerTurn = 4096, kMiddle = 2048, kLargestPwm = 885;

/// [rad] of a number of steps.
double angleOf(double steps);
/// The step nearest to an angle.
std::int64_t stepsOf(double angle);

/// [N m/rad], [N m s/rad] without the induced voltage, and with nothing but it.
double stiffnessOf(const ServoScale& scale, double p_gain);
double dampingOf(const ServoScale& scale, double d_gain);
double inducedDamping(const ServoScale& scale);

/// A number of version 1.0 whose sign is bit 10: set when it is negative, that is clockwise. Cut to 1023.
std::int64_t withSignBit(double value);
double fromSignBit(std::int64_t value);

/// Velocity register of a speed [rad/s].
std::int64_t velocityRegister(const ServoScale& scale, double velocity);
/// Accelerations: [rad/s^2] of a register of profiles.
double accelerationOf(const ServoScale& scale, std::int64_t value);

}  // namespace murosimf::servo_bus
