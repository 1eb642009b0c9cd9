#include "murosimf/robot/device_mount.h"

#include <set>

#include "murosimf/robot/robot_model.h"

namespace murosimf {
namespace {

/// Devices side by side; a name that one has already is left to that one.
class DeviceList {
 public:
  void add(MountedDevice kind, std::string name, std::size_t part, const SourceLocation& where, int corner = -1) {
    if (!names_.insert(name).second) return;
    DeviceMount& device = devices_.emplace_back();
    device.kind = kind, device.name = std::move(name);
    device.part = static_cast<int>(part), device.corner = corner;
    device.where = where;
  }
  std::vector<DeviceMount> take() { return std::move(devices_); }

 private:
  std::vector<DeviceMount> devices_;
  std::set<std::string> names_;
};

void addCorners(const RobotModel& model, const PressureSensorMount& sensor, DeviceList& list) {
  for (std::size_t sole = 0; sole < model.soles.size(); ++sole) {
    if (model.soles[sole].name != sensor.sole) continue;
    for (int corner = 0; corner < 4; ++corner) {
      list.add(MountedDevice::kForce, sensor.name + "_" + kSoleCorners[corner], sole, sensor.where, corner);
    }
  }
}

}  // namespace

std::vector<DeviceMount> defaultDevices(const RobotModel& model) {
  DeviceList list;
  const std::vector<Joint>& joints = model.tree.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) list.add(MountedDevice::kMotor, joints[i].name, i, joints[i].where);
  const auto addAll = [&list](MountedDevice kind, const auto& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) list.add(kind, parts[i].name, i, parts[i].where);
  };
  addAll(MountedDevice::kCamera, model.cameras);
  addAll(MountedDevice::kForce3d, model.force_sensors);
  addAll(MountedDevice::kBumper, model.touch_sensors);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    list.add(MountedDevice::kPositionSensor, joints[i].name + "_sensor", i, joints[i].where);
  }
  for (std::size_t i = 0; i < model.imus.size(); ++i) {
    const ImuMount& imu = model.imus[i];
    list.add(MountedDevice::kImuAccelerometer, imu.name + " accelerometer", i, imu.where);
    list.add(MountedDevice::kImuGyro, imu.name + " gyro", i, imu.where);
  }
  for (const PressureSensorMount& sensor : model.pressure_sensors) addCorners(model, sensor, list);
  return list.take();
}

}  // namespace murosimf
