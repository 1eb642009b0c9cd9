#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

constexpr std::size_t kMostDevices = 1000;

/// What stands in the file for a kind of device.
struct DeviceWords {
  const char* element;
  MountedDevice kind;
  const char* part;   ///< attribute that names the part
  bool is_a_reading;  ///< may be scaled
};
constexpr DeviceWords kWords[] = {{"motor", MountedDevice::kMotor, "joint", false},
                                  {"accelerometer", MountedDevice::kImuAccelerometer, "imu", true},
                                  {"gyro", MountedDevice::kImuGyro, "imu", true},
                                  {"camera", MountedDevice::kCamera, "camera", false},
                                  {"force", MountedDevice::kForce, "pressure_sensor", true},
                                  {"force3d", MountedDevice::kForce3d, "force_sensor", true},
                                  {"bumper", MountedDevice::kBumper, "touch_sensor", false}};

std::string readDeviceName(const XmlElement& element, const char* attribute) {
  const int before = element.diagnostics().errorCount();
  std::string name = element.text(attribute);
  if (element.diagnostics().errorCount() == before) element.check(deviceNameProblem(name));
  return name;
}

void readScale(const XmlElement& element, DeviceMount& device) {
  const int before = element.diagnostics().errorCount();
  device.scale = element.number("scale", device.scale);
  device.offset = element.number("offset", device.offset);
  if (element.has("lowest")) device.lowest = element.number("lowest");
  if (element.has("highest")) device.highest = element.number("highest");
  if (element.diagnostics().errorCount() != before) return;
  if (device.scale == 0) element.errorAt("scale", "is 0, expected what one SI unit adds to the reading");
  if (!(device.lowest < device.highest))
    element.errorAt("highest", fmt::format("is {:g}, expected more than lowest, {:g}", device.highest, device.lowest));
}

void readCorner(const XmlElement& element, DeviceMount& device) {
  if (!element.has("corner")) return;
  const int before = element.diagnostics().errorCount();
  const std::string corner = element.text("corner");
  if (element.diagnostics().errorCount() != before) return;
  const std::vector<std::string> known(std::begin(kSoleCorners), std::end(kSoleCorners));
  const auto found = std::find(known.begin(), known.end(), corner);
  if (found == known.end()) {
    return element.errorAt("corner", fmt::format("is {}, expected one of {}{}", quoted(corner), fmt::join(known, ", "),
                                                 nearestName(element.diagnostics(), corner, known)));
  }
  device.corner = static_cast<int>(found - known.begin());
}

void readDevice(const XmlElement& element, const DeviceWords& words, RobotPart& robot) {
  std::vector<std::string> attributes{"device", words.part};
  if (words.kind == MountedDevice::kMotor) attributes.emplace_back("sensor");
  if (words.kind == MountedDevice::kForce) attributes.emplace_back("corner");
  if (words.is_a_reading) attributes.insert(attributes.end(), {"scale", "offset", "lowest", "highest"});
  element.accept(attributes);
  DevicePart device;
  device.mount.kind = words.kind;
  device.mount.where = element.where();
  device.mount.name = readDeviceName(element, "device");
  device.part = readReference(element, words.part);
  if (words.is_a_reading) readScale(element, device.mount);
  if (words.kind == MountedDevice::kForce) readCorner(element, device.mount);
  robot.devices.push_back(device);
  if (words.kind != MountedDevice::kMotor || !element.has("sensor")) return;
  device.mount.kind = MountedDevice::kPositionSensor;
  device.mount.name = readDeviceName(element, "sensor");
  device.mount.where = element.where("sensor");
  robot.devices.push_back(device);
}

/// Clients know devices by name alone.
void checkDeviceNames(const RobotPart& robot, Diagnostics& diagnostics) {
  std::map<std::string_view, int> lines;
  for (const DevicePart& device : robot.devices) {
    if (device.mount.name.empty()) continue;
    const auto [first, added] = lines.emplace(device.mount.name, device.mount.where.line);
    if (added) continue;
    diagnostics.error(device.mount.where, "device " + quoted(device.mount.name) +
                                              fmt::format(": the name is used in line {} already", first->second));
  }
}

/// Finds the parts that devices name, in one list of the model for each kind.
class Resolver {
 public:
  Resolver(const RobotModel& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  int find(const DevicePart& device) {
    const Reference& part = device.part;
    switch (device.mount.kind) {
      case MountedDevice::kMotor:
      case MountedDevice::kPositionSensor:
        return indexIn(model_.tree.joints, "joint", part);
      case MountedDevice::kImuAccelerometer:
      case MountedDevice::kImuGyro:
        return indexIn(model_.imus, "imu", part);
      case MountedDevice::kCamera:
        return indexIn(model_.cameras, "camera", part);
      case MountedDevice::kForce:
        return findSole(part);
      case MountedDevice::kForce3d:
        return indexIn(model_.force_sensors, "force_sensor", part);
      case MountedDevice::kBumper:
        return indexIn(model_.touch_sensors, "touch_sensor", part);
    }
    return -1;
  }

 private:
  template <class Part>
  int indexIn(const std::vector<Part>& parts, const char* what, const Reference& wanted) {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == wanted.name; });
    if (found != parts.end()) return static_cast<int>(found - parts.begin());
    std::vector<std::string> names;
    for (const Part& part : parts) names.push_back(part.name);
    diagnostics_.error(wanted.where, fmt::format("{} {} does not exist{}", what, quoted(wanted.name),
                                                 nearestName(diagnostics_, wanted.name, names)));
    return -1;
  }

  int findSole(const Reference& wanted) {
    const int sensor = indexIn(model_.pressure_sensors, "pressure_sensor", wanted);
    if (sensor < 0) return -1;
    const std::string& sole = model_.pressure_sensors[static_cast<std::size_t>(sensor)].sole;
    if (!sole.empty()) return indexIn(model_.soles, "sole", {sole, wanted.where});
    diagnostics_.error(wanted.where, "pressure_sensor " + quoted(wanted.name) +
                                         " has points of its own, expected one that names a sole");
    return -1;
  }

  const RobotModel& model_;
  Diagnostics& diagnostics_;
};

/// A joint has one motor, so that two devices never command it.
void refuseSecondMotors(const RobotModel& model, Diagnostics& diagnostics) {
  std::map<int, const DeviceMount*> motors;
  for (const DeviceMount& device : model.devices) {
    if (device.kind != MountedDevice::kMotor) continue;
    const auto [first, added] = motors.emplace(device.part, &device);
    if (added) continue;
    const Joint& joint = model.tree.joints[static_cast<std::size_t>(device.part)];
    diagnostics.error(
        device.where,
        fmt::format("motor {} moves joint {}, as {} in line {} does already, expected one motor a joint",
                    quoted(device.name), quoted(joint.name), quoted(first->second->name), first->second->where.line));
  }
}

}  // namespace

void readPlayerApi(const XmlElement& element, RobotPart& robot) {
  robot.names_devices = true;
  std::vector<std::string> known;
  for (const DeviceWords& words : kWords) known.emplace_back(words.element);
  element.accept({}, known);
  const std::vector<XmlElement> devices = element.children();
  if (devices.size() > kMostDevices) {
    return element.error(fmt::format("has {} devices, expected at most {}", devices.size(), kMostDevices));
  }
  for (const XmlElement& device : devices) {
    const auto words = std::find_if(std::begin(kWords), std::end(kWords),
                                    [&](const DeviceWords& w) { return device.name() == w.element; });
    if (words != std::end(kWords)) readDevice(device, *words, robot);
  }
  checkDeviceNames(robot, element.diagnostics());
}

void resolveDevices(const RobotPart& robot, RobotModel& model, Diagnostics& diagnostics) {
  if (!robot.names_devices) {
    model.devices = defaultDevices(model);
    return;
  }
  Resolver resolver(model, diagnostics);
  int found = -1;
  for (const DevicePart& part : robot.devices) {
    DeviceMount device = part.mount;
    // A position sensor stands behind its motor and is on the same joint, whose mistake is told once.
    if (device.kind != MountedDevice::kPositionSensor) found = resolver.find(part);
    device.part = found;
    if (device.part >= 0) model.devices.push_back(std::move(device));
  }
  refuseSecondMotors(model, diagnostics);
}

}  // namespace murosimf::urdf
