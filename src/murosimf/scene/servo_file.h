#pragma once

/// @file Parameter files of servos: JSON as Rhoban's `bam` writes it [Duclusaud et al. 2025].
///
/// One object with a number a key: kt, R, armature, friction_base, friction_viscous, and what its "model", "m1" to
/// "m6", has besides. What drives the motor comes from the "actuator" that the file names, or from keys of this
/// project: vin, kp, error_gain, max_pwm, max_current. docs/robot_format.md has the table. Keys that nobody knows give
/// warnings.

#include <optional>
#include <string>
#include <vector>

#include "murosimf/world/diagnostics.h"
#include "murosimf/world/property.h"

namespace murosimf {

/// One constant of a servo.
struct ServoConstant {
  const Constant<double>* property = nullptr;
  double value = 0;
};

/// The constants that a file gives, or nothing when at least one error was reported.
std::optional<std::vector<ServoConstant>> readServoFile(const std::string& path, Diagnostics& diagnostics);

/// The same of text that was loaded elsewhere; `file` is the name used in messages.
std::optional<std::vector<ServoConstant>> readServoText(const std::string& text, const std::string& file,
                                                        Diagnostics& diagnostics);

}  // namespace murosimf
