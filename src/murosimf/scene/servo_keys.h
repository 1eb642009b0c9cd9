#pragma once

/// @file The words of servos' parameter files (servo_file.h): keys, friction models, and actuators with what drives
/// them.
///
/// Key names, models and drives are those of the program `bam` [Duclusaud et al. 2025].

#include <string_view>

#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf::servo {

/// Friction models, one bit each: the key belongs to M1, M2, ...
inline constexpr unsigned kAll = 0b111111, kStribeck = 0b111010, kLoad = 0b001100, kLoadStribeck = 0b001000,
                          kDirected = 0b110000, kQuadratic = 0b100000;

/// A key of a file and what its number becomes.
struct Field {
  std::string_view key;
  unsigned models;  ///< that need it
  bool positive;    ///< else 0 is allowed too
  const Constant<double>* property;
  const Constant<double>* other = nullptr;  ///< where one number counts twice
};

inline const Field kFields[] = {
    {"kt", kAll, true, &kTorqueConstant},
    {"R", kAll, true, &kMotorResistance},
    {"armature", kAll, false, &kArmature},
    {"friction_base", kAll, false, &kFrictionBase},
    {"friction_viscous", kAll, false, &kFrictionViscous},
    {"friction_stribeck", kStribeck, false, &kFrictionStribeck},
    {"dtheta_stribeck", kStribeck, true, &kFrictionSpeed},
    {"alpha", kStribeck, true, &kFrictionExponent},
    {"load_friction_base", kLoad, false, &kLoadFrictionMotor, &kLoadFrictionExternal},
    {"load_friction_stribeck", kLoadStribeck, false, &kLoadFrictionMotorStribeck, &kLoadFrictionExternalStribeck},
    {"load_friction_motor", kDirected, false, &kLoadFrictionMotor},
    {"load_friction_external", kDirected, false, &kLoadFrictionExternal},
    {"load_friction_motor_stribeck", kDirected, false, &kLoadFrictionMotorStribeck},
    {"load_friction_external_stribeck", kDirected, false, &kLoadFrictionExternalStribeck},
    {"load_friction_motor_quad", kQuadratic, false, &kLoadFrictionMotorQuad},
    {"load_friction_external_quad", kQuadratic, false, &kLoadFrictionExternalQuad},
};

/// Known, and of no use here: of the bench on which the servo stood, or text for people.
inline constexpr std::string_view kPassedOver[] = {"q_offset", "command_delay", "source"};

/// What turns an error of position into a voltage.
struct Drive {
  std::string_view actuator;
  double supply, firmware_gain, error_gain, largest_duty;  ///< [V, 1, 1/rad, 1]
};

/// As measured by the authors of bam, in whose files they do not stand; XL330: steps of 2 pi/4096, 256 parts, 885 PWM.
inline constexpr Drive kDrives[] = {
    {"mx64", 15, 32, 0.158, 0.9625},   {"mx106", 15, 32, 0.158, 0.9625},
    {"xl320", 7.5, 32, 0.05048199, 1}, {"xl330", 7.5, 400, 4096 / (2 * 3.14159265358979323846) / (256 * 885), 1},
    {"sts3215", 7.4, 32, 0.166, 0.97}, {"waveshare_st3025", 12, 32, 0.166, 1}};

/// Driven by current or torque, not by voltage.
inline constexpr std::string_view kOtherDrives[] = {"erob80_50", "erob80_100", "xl330i", "feetech_hls", "unitree_go1"};

}  // namespace murosimf::servo
