// The devices of the player API in robot files.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

/// A head that turns on a foot, with one of everything that is a device.
RobotModel robotWith(const std::string& api) {
  const std::string mass = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";
  const std::string text =
      "<robot name='head_on_foot'><murosimf>" + api +
      "</murosimf>"
      "<link name='foot'>" +
      mass +
      "<collision><geometry><box size='0.2 0.1 0.02'/></geometry></collision><murosimf>"
      "<sole name='sole' xyz='0 0 -0.01' size='0.2 0.1'/>"
      "<pressure_sensor name='pressure' sole='sole'/><touch_sensor name='toes'/>"
      "<imu name='imu'/></murosimf></link>"
      "<joint name='neck' type='continuous'><parent link='foot'/><child link='head'/>"
      "<limit effort='1' velocity='1'/></joint>"
      "<link name='head'>" +
      mass +
      "<murosimf><imu name='imu_head'/><force_sensor name='neck_force'/>"
      "<camera name='eye' width='64' height='48' hfov='1' period='0.1'/></murosimf></link></robot>";
  Diagnostics diagnostics;
  ReadResult model = readUrdfText(text, "robot.urdf", diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  return model ? *model : RobotModel{};
}

std::vector<std::string> namesOf(const RobotModel& model) {
  std::vector<std::string> names;
  for (const DeviceMount& device : model.devices) names.push_back(device.name);
  return names;
}

const DeviceMount& find(const RobotModel& model, const std::string& name) {
  for (const DeviceMount& device : model.devices) {
    if (device.name == name) return device;
  }
  throw std::runtime_error("there is no device " + name);
}

TEST(Devices, StandInTheOrderOfTheFileAndMotorsBringTheirSensors) {
  const RobotModel model = robotWith(
      "<player_api><gyro device='Gyro' imu='imu_head'/><motor device='Neck [hip]' joint='neck' sensor='NeckS'/>"
      "<camera device='Camera' camera='eye'/><bumper device='bump' touch_sensor='toes'/>"
      "<force3d device='f3' force_sensor='neck_force'/></player_api>");
  EXPECT_EQ(namesOf(model), (std::vector<std::string>{"Gyro", "Neck [hip]", "NeckS", "Camera", "bump", "f3"}));
  EXPECT_EQ(find(model, "Gyro").kind, MountedDevice::kImuGyro);
  EXPECT_EQ(find(model, "Gyro").part, 1);
  EXPECT_EQ(find(model, "Neck [hip]").kind, MountedDevice::kMotor);
  EXPECT_EQ(find(model, "NeckS").kind, MountedDevice::kPositionSensor);
  EXPECT_EQ(find(model, "NeckS").part, 0);
  EXPECT_EQ(find(model, "Camera").kind, MountedDevice::kCamera);
  EXPECT_EQ(find(model, "bump").kind, MountedDevice::kBumper);
  EXPECT_EQ(find(model, "f3").kind, MountedDevice::kForce3d);
}

TEST(Devices, AreReadAsTheNumbersThatTheFileTells) {
  const RobotModel model = robotWith(
      "<player_api><accelerometer device='a' imu='imu' scale='13.05' offset='512' lowest='0' highest='1024'/>"
      "<accelerometer device='b' imu='imu'/></player_api>");
  const DeviceMount &a = find(model, "a"), &b = find(model, "b");
  EXPECT_EQ(a.kind, MountedDevice::kImuAccelerometer);
  EXPECT_EQ(a.scale, 13.05);
  EXPECT_EQ(a.offset, 512);
  EXPECT_EQ(a.lowest, 0);
  EXPECT_EQ(a.highest, 1024);
  EXPECT_EQ(b.scale, 1);
  EXPECT_EQ(b.offset, 0);
  EXPECT_TRUE(std::isinf(b.lowest) && b.lowest < 0 && std::isinf(b.highest) && b.highest > 0);
}

TEST(Devices, OfForceAreCornersOfASoleOrTheirSum) {
  const RobotModel model = robotWith(
      "<player_api><force device='sum' pressure_sensor='pressure'/>"
      "<force device='rr' pressure_sensor='pressure' corner='rear_right'/>"
      "<force device='fr' pressure_sensor='pressure' corner='front_right'/>"
      "<force device='rl' pressure_sensor='pressure' corner='rear_left'/>"
      "<force device='fl' pressure_sensor='pressure' corner='front_left'/></player_api>");
  EXPECT_EQ(find(model, "sum").corner, -1);
  EXPECT_EQ(find(model, "rr").corner, 0);  // (-x -y), y to the left
  EXPECT_EQ(find(model, "fr").corner, 1);
  EXPECT_EQ(find(model, "rl").corner, 2);
  EXPECT_EQ(find(model, "fl").corner, 3);
}

TEST(Devices, OfAFileThatNamesNoneAreAllItsPartsByTheirNames) {
  const RobotModel model = robotWith("");
  EXPECT_EQ(namesOf(model),
            (std::vector<std::string>{"neck", "eye", "neck_force", "toes", "neck_sensor", "imu accelerometer",
                                      "imu gyro", "imu_head accelerometer", "imu_head gyro", "pressure_rear_right",
                                      "pressure_front_right", "pressure_rear_left", "pressure_front_left"}));
  EXPECT_EQ(find(model, "imu_head gyro").part, 1);
  EXPECT_EQ(find(model, "pressure_front_left").corner, 3);
}

TEST(Devices, OfAnEmptyListAreNone) { EXPECT_TRUE(robotWith("<player_api/>").devices.empty()); }

TEST(Devices, BeyondAThousandAreRefused) {
  std::string api = "<player_api>";
  for (int i = 0; i < 1001; ++i) api += "<gyro device='g" + std::to_string(i) + "' imu='imu'/>";
  Diagnostics diagnostics;
  EXPECT_FALSE(
      readUrdfText("<robot name='r'><murosimf>" + api + "</player_api></murosimf></robot>", "r.urdf", diagnostics));
  EXPECT_NE(diagnostics.text().find("has 1001 devices, expected at most 1000"), std::string::npos)
      << diagnostics.text();
}

}  // namespace
}  // namespace murosimf
