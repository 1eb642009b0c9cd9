#pragma once

/// @file Puts what servos' parameter files say on the joints of a robot.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene/servo_file.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// Reads every file once, however many joints and robots use it.
class ServoBuilder {
 public:
  explicit ServoBuilder(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Sets the constants of all joints of `robot` that have a servo_file: their own, or for those with a servo the
  /// robot's. What the scenario says goes before what the robot's file says; of the same file the joint's goes before
  /// the robot's. A constant that somebody wrote as a property goes before the file's. "none" is no file.
  /// Files are looked for from the place where they are named (robot_reader.h).
  void apply(World& world, ObjectId robot, const std::string& robot_file);

 private:
  const std::vector<ServoConstant>* read(const std::string& name, const SourceLocation& where);

  Diagnostics& diagnostics_;
  std::map<std::string, std::optional<std::vector<ServoConstant>>> files_;  ///< by the path; by the name if not found
};

}  // namespace murosimf
