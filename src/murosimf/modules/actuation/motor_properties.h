#pragma once

/// @file Constants of servos with a direct-current motor, as their parameter files give them (docs/robot_format.md),
/// and the variables in which the modules of such servos meet. All quantities are seen at the joint, behind the gear.

#include <limits>
#include <string>

#include "murosimf/world/property.h"

namespace murosimf {

/// Of a joint, or of a robot for all its joints with a servo.
inline constexpr Constant<std::string> kServoFile{"servo_file", "", "parameter file of the servo"};

inline constexpr Constant<double> kTorqueConstant{"torque_constant", "N m/A", "torque per current; V s/rad"};
inline constexpr Constant<double> kMotorResistance{"motor_resistance", "Ohm", "of the winding"};
inline constexpr Constant<double> kSupplyVoltage{"supply_voltage", "V", "of the servo"};
inline constexpr Constant<double> kFirmwareGain{"firmware_kp", "1", "gain of the position controller"};
inline constexpr Constant<double> kErrorGain{"error_gain", "1/rad", "duty cycle per error and firmware_kp"};
inline constexpr Constant<double> kLargestDuty{"largest_duty", "1", "of the voltage, share of the supply's"};
inline constexpr Constant<double> kLargestCurrent{"largest_current", "A", "that the firmware lets through"};

inline constexpr Constant<double> kFrictionViscous{"friction_viscous", "N m s/rad", "of the gear"};
inline constexpr Constant<double> kFrictionBase{"friction_base", "N m", "dry friction of the gear"};
inline constexpr Constant<double> kFrictionStribeck{"friction_stribeck", "N m", "more of it at rest"};
inline constexpr Constant<double> kLoadFrictionMotor{"load_friction_motor", "1", "per torque of the motor"};
inline constexpr Constant<double> kLoadFrictionExternal{"load_friction_external", "1", "per torque of the load"};
inline constexpr Constant<double> kLoadFrictionMotorStribeck{"load_friction_motor_stribeck", "1", "more of it at rest"};
inline constexpr Constant<double> kLoadFrictionExternalStribeck{"load_friction_external_stribeck", "1",
                                                                "more of it at rest"};
inline constexpr Constant<double> kLoadFrictionMotorQuad{"load_friction_motor_quad", "1/(N m)",
                                                         "per squared torque of the motor"};
inline constexpr Constant<double> kLoadFrictionExternalQuad{"load_friction_external_quad", "1/(N m)",
                                                            "per squared torque of the load"};
inline constexpr Constant<double> kFrictionSpeed{"friction_speed", "rad/s", "at which the more at rest has faded"};
inline constexpr Constant<double> kFrictionExponent{"friction_exponent", "1", "with which it fades"};

/// Values of constants that a servo may lack.
inline constexpr double kDefaultDuty = 1, kNoCurrentLimit = std::numeric_limits<double>::infinity();
inline constexpr double kDefaultFrictionSpeed = 0.2, kDefaultFrictionExponent = 1.35;

inline constexpr Variable<double> kMotorTorque{"motor_torque", "N m", "of motor and gear, before the step",
                                               Storage::kStep};
inline constexpr Variable<double> kMotorInertia{"motor_inertia", "kg m^2", "what of it depends on acceleration",
                                                Storage::kStep};
inline constexpr Variable<double> kGearLoad{"gear_load", "N m", "torque of the link on the gear"};

}  // namespace murosimf
