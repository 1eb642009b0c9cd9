#pragma once

/// @file The devices by which control software of the RoboCup Humanoid virtual season knows a robot's parts: its
/// motors, sensors and cameras under names of their own (docs/robot_format.md).

#include <limits>
#include <string>
#include <vector>

#include "murosimf/world/diagnostics.h"

namespace murosimf {

struct RobotModel;

enum class MountedDevice { kMotor, kPositionSensor, kImuAccelerometer, kImuGyro, kCamera, kForce, kForce3d, kBumper };

/// The corners of a sole in the order of its pressures: (-x -y), (+x -y), (-x +y), (+x +y), y to the left.
inline constexpr const char* kSoleCorners[4] = {"rear_right", "front_right", "rear_left", "front_left"};

/// What is read of a device is clamp(offset + scale * value, lowest, highest), in SI units before.
struct DeviceMount {
  MountedDevice kind = MountedDevice::kMotor;
  std::string name{};
  int part = -1;    ///< index into the model's joints, imus, cameras, soles, force_sensors or touch_sensors
  int corner = -1;  ///< of a sole, index into kSoleCorners; -1: the sum of all
  double scale = 1, offset = 0;
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
  SourceLocation where{};
};

/// The devices of a robot whose file names none, each by its part's name: motors JOINT with position sensors
/// JOINT_sensor, "IMU accelerometer" and "IMU gyro", cameras, PRESSURE_SENSOR_rear_right and so on for the corners,
/// force sensors, touch sensors. Names of parts go before names made of them: of two devices of one name the second is
/// left out.
std::vector<DeviceMount> defaultDevices(const RobotModel& model);

}  // namespace murosimf
