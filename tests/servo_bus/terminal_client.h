#pragma once

/// @file A program at the other end of the terminal, and a robot of two joints for the bus.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "murosimf/control/servo_bus/servo_bus.h"
#include "servo_bus/bytes.h"

namespace murosimf::servo_bus {

/// Opens the link as any program would, and leaves its settings as they are.
class TerminalClient {
 public:
  explicit TerminalClient(const std::string& link)
      : end_(checkedCall(::open(link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK), link)) {}

  void send(const Bytes& bytes) const {
    EXPECT_EQ(::write(end_.number(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  /// Sends as much as the terminal takes. @returns how much that is
  std::size_t flood(const Bytes& bytes) const {
    const ssize_t count = ::write(end_.number(), bytes.data(), bytes.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  /// Whether something comes within that time.
  bool hears(int patience_ms) const {
    pollfd wait{end_.number(), POLLIN, 0};
    return ::poll(&wait, 1, patience_ms) > 0;
  }
  /// What has come.
  Bytes take() const {
    Bytes part(4096);
    const ssize_t count = ::read(end_.number(), part.data(), part.size());
    part.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return part;
  }
  /// What comes until nothing has come for a while.
  Bytes receive(int patience_ms = 200) const {
    Bytes all;
    for (; hears(patience_ms); patience_ms = 20) {
      const Bytes part = take();
      if (part.empty()) break;
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

 private:
  FileDescriptor end_;
};

/// Two joints with servos 1 and 2.
inline ServoBusSettings twoServos(const std::string& name) {
  ServoBusSettings settings;
  settings.link = ::testing::TempDir() + "murosimf_servo_bus_" + std::to_string(::getpid()) + "/" + name;
  ServoSettings pan, tilt;
  pan.id = 1, pan.model = "MX-64", pan.joint = "pan";
  tilt.id = 2, tilt.model = "MX-28", tilt.joint = "tilt";
  settings.servos = {pan, tilt};
  return settings;
}

inline client::RobotDescription twoJoints() {
  client::RobotDescription robot;
  robot.model = "box", robot.team = "red", robot.number = 3;
  robot.joints = {{"pan", -3, 3, 5, 6}, {"tilt", -3, 3, 5, 2}};
  return robot;
}

/// A bus whose steps the test takes.
struct SteppedBus {
  explicit SteppedBus(const ServoBusSettings& settings) : bus(settings) {
    bus.start(twoJoints());
    commands.joints.resize(2);
  }
  void step() {
    sensors.time = t;
    sensors.joints = joints;
    bus.step(sensors, commands);
    t += 0.01;
  }
  std::string link() const { return bus.terminal()->link(); }

  ServoBus bus;
  std::vector<client::JointReading> joints = std::vector<client::JointReading>(2);
  client::SensorFrame sensors;
  client::CommandFrame commands;
  double t = 0;
};

}  // namespace murosimf::servo_bus
