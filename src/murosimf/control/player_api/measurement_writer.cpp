#include "murosimf/control/player_api/measurement_writer.h"

#include <algorithm>
#include <utility>

#include "murosimf/control/player_api/player_api.pb.h"

namespace murosimf::player_api {

namespace {

using client::DeviceDescription;
using client::DeviceKind;

client::ImuReading imuOf(const client::SensorFrame& sensors, int imu) {
  const auto i = static_cast<std::size_t>(imu);
  return i < sensors.imus.size() ? sensors.imus[i]
                                 : client::ImuReading{sensors.angular_velocity, sensors.specific_force};
}

void setScaled(const DeviceDescription& device, const murosimf::Vector3& value, Vector3& out) {
  out.set_x(deviceValue(device, value.x));
  out.set_y(deviceValue(device, value.y));
  out.set_z(deviceValue(device, value.z));
}

double soleForce(const client::SensorFrame& sensors, const DeviceDescription& device) {
  const auto sole = static_cast<std::size_t>(device.part);
  if (sole >= sensors.sole_pressures.size()) return 0;
  const std::array<double, 4>& corners = sensors.sole_pressures[sole];
  return device.corner >= 0 ? corners[static_cast<std::size_t>(device.corner)]
                            : corners[0] + corners[1] + corners[2] + corners[3];
}

void writePosition(const DeviceDescription& device, const client::SensorFrame& sensors, bool extended,
                   SensorMeasurements& out) {
  const client::JointReading& joint = sensors.joints[static_cast<std::size_t>(device.part)];
  PositionSensorMeasurement& m = *out.add_position_sensors();
  m.set_name(device.name);
  m.set_value(deviceValue(device, joint.position));
  if (extended) m.set_velocity(joint.velocity), m.set_torque(joint.torque);
}

/// Blue, green, red; false for pixels of two bytes.
bool setImage(const client::CameraPicture& picture, std::string& image) {
  if (picture.format == client::PixelFormat::kYuyv) return false;
  image.assign(picture.bytes.begin(), picture.bytes.end());
  if (picture.format == client::PixelFormat::kBgr) return true;
  for (std::size_t i = 0; i + 2 < image.size(); i += 3) std::swap(image[i], image[i + 2]);
  return true;
}

void writePictures(const DeviceDescription& device, const client::SensorFrame& sensors, bool extended,
                   SensorMeasurements& out) {
  for (const client::CameraPicture& picture : sensors.pictures) {
    if (picture.camera != device.part) continue;
    CameraMeasurement& m = *out.add_cameras();
    m.set_name(device.name);
    m.set_width(static_cast<std::uint32_t>(picture.width));
    m.set_height(static_cast<std::uint32_t>(picture.height));
    m.set_quality(-1);
    if (extended) m.set_time(picture.time);
    if (setImage(picture, *m.mutable_image())) continue;
    out.mutable_cameras()->RemoveLast();
    Message& message = *out.add_messages();
    message.set_message_type(Message::ERROR_MESSAGE);
    message.set_text("\"" + device.name + "\" takes pictures in format yuyv, expected bgr or rgb in the scenario");
  }
}

void writeDevice(const DeviceDescription& device, const client::SensorFrame& sensors, bool extended,
                 SensorMeasurements& out) {
  const auto part = static_cast<std::size_t>(device.part);
  switch (device.kind) {
    case DeviceKind::kMotor:
      return;
    case DeviceKind::kPositionSensor:
      return writePosition(device, sensors, extended, out);
    case DeviceKind::kAccelerometer: {
      AccelerometerMeasurement& m = *out.add_accelerometers();
      m.set_name(device.name);
      return setScaled(device, imuOf(sensors, device.part).specific_force, *m.mutable_value());
    }
    case DeviceKind::kGyro: {
      GyroMeasurement& m = *out.add_gyros();
      m.set_name(device.name);
      return setScaled(device, imuOf(sensors, device.part).angular_velocity, *m.mutable_value());
    }
    case DeviceKind::kCamera:
      return writePictures(device, sensors, extended, out);
    case DeviceKind::kForce: {
      ForceMeasurement& m = *out.add_forces();
      m.set_name(device.name);
      return m.set_value(deviceValue(device, soleForce(sensors, device)));
    }
    case DeviceKind::kForce3d: {
      Force3DMeasurement& m = *out.add_force3ds();
      m.set_name(device.name);
      return setScaled(device, part < sensors.forces.size() ? sensors.forces[part] : murosimf::Vector3{},
                       *m.mutable_value());
    }
    case DeviceKind::kBumper: {
      BumperMeasurement& m = *out.add_bumpers();
      m.set_name(device.name);
      return m.set_value(part < sensors.touches.size() && sensors.touches[part] != 0);
    }
  }
}

}  // namespace

void writeMeasurements(const DeviceBook& devices, const SensorSchedule& schedule, const client::SensorFrame& sensors,
                       long now, bool extended, SensorMeasurements& out) {
  for (int i = 0; i < devices.count(); ++i) {
    if (schedule.isDue(i, now)) writeDevice(devices.device(i), sensors, extended, out);
  }
}

}  // namespace murosimf::player_api
