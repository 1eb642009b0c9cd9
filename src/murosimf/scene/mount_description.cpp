#include "murosimf/scene/mount_description.h"

#include <algorithm>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// A robot with its bodies' places on the base, joints at zero.
class Posture {
 public:
  explicit Posture(const RobotModel& model)
      : model_(model), elements_(elementPoses(model.tree, std::vector<double>(model.tree.joints.size(), 0.0))) {}
  const Body& body(int index) const { return model_.tree.bodies[static_cast<std::size_t>(index)]; }
  const Pose& place(int index) const { return elements_[static_cast<std::size_t>(body(index).element)]; }

 private:
  const RobotModel& model_;
  std::vector<Pose> elements_;
};

client::WheelDescription wheelOf(const WheelMount& wheel, const Posture& posture) {
  const Pose& X_BaseBody = posture.place(wheel.body);
  client::WheelDescription d;
  d.name = wheel.name;
  d.joint = wheel.feet == WheelFeet::kCastor ? -1 : posture.body(wheel.body).joint;
  d.centre = X_BaseBody * wheel.p_BW;
  d.axle = X_BaseBody.rotation * wheel.axle;
  d.radius = wheel.radius;
  d.rollers = wheel.feet == WheelFeet::kRollers;
  d.roller_angle = wheel.roller_angle;
  return d;
}

client::RangeSensorDescription rangeSensorOf(const RangeSensorMount& sensor, const Posture& posture) {
  client::RangeSensorDescription d;
  d.name = sensor.name;
  d.body = posture.body(sensor.body).name;
  d.X_BS = posture.place(sensor.body) * sensor.X_BS;
  d.angles = sensor.angles.empty() ? std::vector<double>{0.0} : sensor.angles;
  d.half_angle = sensor.half_angle;
  d.least = sensor.least, d.largest = sensor.largest;
  d.period = sensor.period;
  return d;
}

client::TouchSensorDescription touchSensorOf(const TouchSensorMount& sensor, const Posture& posture) {
  client::TouchSensorDescription d;
  const Body& body = posture.body(sensor.body);
  d.name = sensor.name, d.body = body.name;
  d.threshold = sensor.threshold;
  Vector3 sum;
  double count = 0;
  for (const BodyShape& shape : body.shapes) {
    if (!shape.collides) continue;
    sum += shape.X_BS.translation;
    count += 1;
  }
  d.centre = posture.place(sensor.body) * (sum * (1 / max(count, 1.0)));
  return d;
}

static_assert(static_cast<int>(MountedDevice::kMotor) == static_cast<int>(client::DeviceKind::kMotor));
static_assert(static_cast<int>(MountedDevice::kBumper) == static_cast<int>(client::DeviceKind::kBumper));

/// Clients count soles by side, the model in the order of the file.
int clientPart(const DeviceMount& device, const RobotModel& model, const client::RobotDescription& d) {
  if (device.kind != MountedDevice::kForce) return device.part;
  const std::string& sole = model.soles[static_cast<std::size_t>(device.part)].name;
  return static_cast<int>(std::find(d.soles.begin(), d.soles.end(), sole) - d.soles.begin());
}

}  // namespace

void describeDevices(const RobotModel& model, client::RobotDescription& d) {
  for (const DeviceMount& device : model.devices) {
    client::DeviceDescription& told = d.devices.emplace_back();
    told.kind = static_cast<client::DeviceKind>(device.kind);
    told.name = device.name;
    told.part = clientPart(device, model, d);
    told.corner = device.corner;
    told.scale = device.scale, told.offset = device.offset;
    told.lowest = device.lowest, told.highest = device.highest;
  }
}

void describeMounts(const World& world, ObjectId robot, const RobotModel& model, client::RobotDescription& d) {
  const Posture posture(model);
  for (const WheelMount& wheel : model.wheels) d.wheels.push_back(wheelOf(wheel, posture));
  for (const RangeSensorMount& sensor : model.range_sensors) {
    d.range_sensors.push_back(rangeSensorOf(sensor, posture));
    const ObjectId object = world.members(robot, subset::kRangeSensors)[d.range_sensors.size() - 1];
    d.range_sensors.back().period = world.find(object, kRangePeriod).value_or(sensor.period);
  }
  for (const TouchSensorMount& sensor : model.touch_sensors) {
    d.touch_mounts.push_back(touchSensorOf(sensor, posture));
    const ObjectId object = world.members(robot, subset::kTouchSensors)[d.touch_mounts.size() - 1];
    d.touch_mounts.back().threshold = world.find(object, kTouchThreshold).value_or(sensor.threshold);
  }
}

}  // namespace murosimf
