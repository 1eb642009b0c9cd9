#pragma once

/// @file A robot port: two plain frames, sensors out and commands in, between one robot and its control software.

#include <array>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "murosimf/linking/linked_world.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// A value that a sensor gives: what it reads, where the robot has a module for its errors, else what is.
template <class T>
struct Sensed {
  Handle<T> truth, reading;
  bool valid() const { return truth.valid(); }
  int size() const { return truth.size(); }
  T get(int object = 0) const { return reading.valid() ? reading.get(object) : truth.get(object); }
};

/// Joins the properties of one robot with the frames of its control software. A command that is not finite is refused
/// here, joint by joint, before it can enter physics.
class RobotPort {
 public:
  /// What it takes of and gives to robots: attach this when linking.
  static const OutsideAccess& robotAccess();

  RobotPort(LinkedWorld& linked, ObjectId robot, client::RobotDescription description);

  ObjectId robot() const { return robot_; }
  const client::RobotDescription& description() const { return description_; }

  /// Reads joints, inertial sensors, soles, touch and force sensors as they are now. Pictures, messages and game are
  /// the caller's to add.
  void readSensors(double t, client::SensorFrame& sensors);
  /// A command frame of the right size in which every joint asks for nothing.
  client::CommandFrame emptyCommands() const;
  /// Puts commands into force. @returns how many joints' commands were refused: not finite, or kp or kd below zero.
  int applyCommands(const client::CommandFrame& commands);

 private:
  void readImus(client::SensorFrame& sensors);
  bool touches(int sole) const;
  std::array<double, 4> pressureOf(int sole) const;
  ObjectId robot_;
  client::RobotDescription description_;
  Handle<ServoCommand> command_;
  Handle<double> clearance_;
  Sensed<double> position_, velocity_, torque_;
  Sensed<CornerForces<>> pressure_;            // of soles
  Sensed<Vector3> gyroscope_, accelerometer_;  // of inertial measurement units
  Sensed<double> touch_;                       // of touch sensors
  Sensed<Vector3> force_;                      // of force sensors
  std::vector<client::JointReading> joints_;
  std::vector<client::ImuReading> imus_;
  std::vector<std::uint8_t> sole_touches_;
  std::vector<std::array<double, 4>> sole_pressures_;
  std::vector<std::uint8_t> touches_;
  std::vector<Vector3> forces_;
};

}  // namespace murosimf
