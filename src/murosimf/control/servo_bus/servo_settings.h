#pragma once

/// @file What a scenario says of a servo bus.

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/control/servo_bus/packet.h"

namespace murosimf::servo_bus {

/// What the robot's joints make of a command.
enum class Gains : std::uint8_t {
  kServo,     ///< gains of the robot file; a command's velocity is a speed limit
  kCommanded  ///< the command's own (`commanded_gains` of servo_controller): its velocity is that of the goal
};

struct ServoSettings {
  int id = 1;
  std::string model;  ///< a name of modelNames()
  std::string joint;  ///< of the robot file
  double zero = 0;    ///< angle of the joint at which the servo stands in its middle, 2048 [rad]
  int direction = 1;  ///< 1: the joint's angle grows as the servo's does, counterclockwise; -1: it falls
};

struct ImuSettings {
  int id = 241;
  std::string imu;  ///< of the robot file; empty: the first
};

struct ServoBusSettings {
  Protocol protocol = Protocol::k2;
  std::string link;      ///< path of the link to the terminal: /tmp/murosimf/red.1; {team}, {number} are filled in
  double baud_rate = 0;  ///< that paces the answers [1/s]; 0: they come at once
  double return_delay = 5e-4;  ///< first value of Return Delay Time [s], at most 508e-6; counts where baud_rate does
  double supply_voltage = 12;  ///< [V]
  double temperature = 30;     ///< that the servos tell [deg C]
  double overload_time = 1;    ///< that a servo bears 95 % of its stall torque before it shuts down [s]; 0: for ever
  Gains gains = Gains::kServo;
  bool torque_on = false;  ///< servos hold their first position before anybody has switched them on
  bool lock_step = false;  ///< a step waits until goals have been written since the last one
  double patience = 0.1;   ///< that it waits at most [s]; 1 s in 25 s in all
  std::vector<ServoSettings> servos;
  std::vector<ImuSettings> imus;
};

}  // namespace murosimf::servo_bus
