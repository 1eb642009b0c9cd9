#include <fmt/format.h>

#include <algorithm>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

Sole readSole(const XmlElement& element, RobotPart& robot) {
  element.accept({"name", "side", "xyz", "rpy", "size"}, {"property"});
  Sole sole;
  sole.name = readName(element);
  sole.where = element.where();
  sole.X_BSole = element.pose();
  const std::string side = element.text("side", "");
  if (element.has("side") && side != "left" && side != "right") {
    element.errorAt("side", "is " + quoted(side) + ", expected left or right");
  }
  sole.side = side == "left" ? Side::kLeft : side == "right" ? Side::kRight : Side::kNone;
  const int before = element.diagnostics().errorCount();
  const std::vector<double> size = element.numbers("size", 2);
  sole.length = size[0], sole.width = size[1];
  if (element.diagnostics().errorCount() == before && (size[0] <= 0 || size[1] <= 0)) {
    element.errorAt("size", "is not positive, expected length and width of the sole [m]");
  }
  readProperties(element, sole.name, robot);
  return sole;
}

ImuMount readImu(const XmlElement& element, RobotPart& robot) {
  element.accept({"name", "xyz", "rpy"}, {"property"});
  ImuMount imu{.name = readName(element), .X_BI = element.pose(), .where = element.where()};
  readProperties(element, imu.name, robot);
  return imu;
}

/// Points given as numbers, or the corners of a sole of the same link.
PressureSensorMount readPressureSensor(const XmlElement& element, const LinkPart& link, RobotPart& robot) {
  element.accept({"name", "sole", "points"}, {"property"});
  PressureSensorMount sensor{.name = readName(element), .where = element.where()};
  readProperties(element, sensor.name, robot);
  if (element.has("sole") == element.has("points")) {
    element.error("expected either \"sole\" (a sole of this link) or \"points\" (x y z of each)");
    return sensor;
  }
  if (element.has("sole")) {
    const std::string wanted = element.text("sole");
    std::vector<std::string> names;
    for (const Sole& sole : link.soles) {
      names.push_back(sole.name);
      const std::array<Vector3, 4> corners = sole.corners();
      if (sole.name == wanted) sensor.points.assign(corners.begin(), corners.end()), sensor.sole = wanted;
    }
    if (sensor.points.empty()) {
      element.errorAt("sole", "is " + quoted(wanted) + ", which is no sole of this link" +
                                  nearestName(element.diagnostics(), wanted, names));
    }
    return sensor;
  }
  const std::vector<double> numbers = element.numbers("points");
  if (numbers.size() % 3 != 0) {
    element.errorAt("points", fmt::format("has {} numbers, expected three for each point", numbers.size()));
  }
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    sensor.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return sensor;
}

/// It feels what touches the shapes of its link: there must be some.
TouchSensorMount readTouchSensor(const XmlElement& element, const LinkPart& link, RobotPart& robot) {
  element.accept({"name", "threshold"}, {"property"});
  TouchSensorMount sensor{.name = readName(element), .where = element.where()};
  const int before = element.diagnostics().errorCount();
  sensor.threshold = element.number("threshold", sensor.threshold);
  if (element.diagnostics().errorCount() == before && sensor.threshold < 0) {
    element.errorAt("threshold", fmt::format("is {:g} N, expected 0 or more", sensor.threshold));
  }
  const std::vector<BodyShape>& shapes = link.body.shapes;
  if (std::none_of(shapes.begin(), shapes.end(), [](const BodyShape& shape) { return shape.collides; })) {
    element.error("stands in a link that touches nothing, expected one with a <collision>");
  }
  if (!link.touch_sensors.empty()) {
    element.error(fmt::format("is the second of its link, after the one in line {}, expected one",
                              link.touch_sensors.front().where.line));
  }
  readProperties(element, sensor.name, robot);
  return sensor;
}

ForceSensorMount readForceSensor(const XmlElement& element, RobotPart& robot) {
  element.accept({"name", "xyz", "rpy"}, {"property"});
  ForceSensorMount sensor{.name = readName(element), .X_BM = element.pose(), .where = element.where()};
  readProperties(element, sensor.name, robot);
  return sensor;
}

void readServoType(const XmlElement& element, RobotPart& robot) {
  const int before = element.diagnostics().errorCount();
  element.accept({"name", "stall_torque", "no_load_speed", "kp", "kd", "armature", "resolution", "backlash", "file"});
  ServoParameters servo{.type = element.text("name"),
                        .stall_torque = element.number("stall_torque"),
                        .no_load_speed = element.number("no_load_speed"),
                        .kp = element.number("kp"),
                        .kd = element.number("kd"),
                        .armature = element.number("armature", 0),
                        .resolution = element.number("resolution", 0),
                        .backlash = element.number("backlash", 0),
                        .file = element.text("file", "")};
  if (element.diagnostics().errorCount() == before) element.check(servoProblem(servo));
  if (!servo.type.empty() && !robot.servo_types.emplace(servo.type, servo).second) {
    element.error("servo type " + quoted(servo.type) + " is defined twice");
  }
}

}  // namespace

std::string readName(const XmlElement& element) {
  const int before = element.diagnostics().errorCount();
  std::string name = element.text("name");
  if (element.diagnostics().errorCount() != before) return "";
  const std::string problem = nameProblem(name);
  element.check(problem);
  return problem.empty() ? name : "";
}

std::string nearestName(const Diagnostics& diagnostics, const std::string& word, std::vector<std::string> candidates) {
  if (diagnostics.errorCount() > 100) return "";
  if (candidates.size() > 300) candidates.resize(300);
  return didYouMean(std::string_view(word).substr(0, 100), candidates);
}

Reference readReference(const XmlElement& element, const char* attribute) {
  return {element.text(attribute), element.where(attribute)};
}

void readProperties(const XmlElement& owner, const std::string& object, RobotPart& robot) {
  const bool of_robot = object.empty();
  for (const XmlElement& element : owner.children("property")) {
    std::vector<std::string> attributes{"name", "value"};
    if (of_robot) attributes.push_back("object");
    element.accept(attributes);
    PropertyKey key{of_robot ? element.text("object", "") : object, readName(element)};
    PropertyText text{.text = element.text("value"), .where = element.where()};
    const std::vector<std::string> words = splitWords(text.text);
    for (const std::string& word : words) {
      if (const std::optional<double> number = parseNumber(word)) text.numbers.push_back(*number);
    }
    if (text.numbers.size() != words.size()) text.numbers.clear();
    robot.properties.emplace_back(std::move(key), std::move(text));
  }
}

void readMounts(const XmlElement& extension, LinkPart& link, RobotPart& robot) {
  for (const XmlElement& sole : extension.children("sole")) link.soles.push_back(readSole(sole, robot));
  for (const XmlElement& camera : extension.children("camera")) link.cameras.push_back(readCamera(camera, robot));
  for (const XmlElement& imu : extension.children("imu")) link.imus.push_back(readImu(imu, robot));
  for (const XmlElement& sensor : extension.children("pressure_sensor")) {
    link.pressure_sensors.push_back(readPressureSensor(sensor, link, robot));
  }
  for (const XmlElement& sensor : extension.children("touch_sensor")) {
    link.touch_sensors.push_back(readTouchSensor(sensor, link, robot));
  }
  for (const XmlElement& sensor : extension.children("force_sensor")) {
    link.force_sensors.push_back(readForceSensor(sensor, robot));
  }
  for (const XmlElement& sensor : extension.children("laser_scanner")) {
    link.range_sensors.push_back(readLaserScanner(sensor, robot));
  }
  for (const XmlElement& sensor : extension.children("distance_sensor")) {
    link.range_sensors.push_back(readDistanceSensor(sensor, robot));
  }
  for (const XmlElement& wheel : extension.children("wheel")) link.wheels.push_back(readWheel(wheel, link, robot));
  for (const XmlElement& castor : extension.children("castor")) link.wheels.push_back(readCastor(castor, link, robot));
}

void readRobotExtension(const XmlElement& extension, RobotPart& robot) {
  extension.accept({"surface", "ignore_contacts_within"}, {"servo_type", "ignore_contact", "property", "player_api"});
  robot.surface = extension.text("surface", robot.surface);
  if (extension.has("ignore_contacts_within")) {
    robot.ignore_within = extension.integer("ignore_contacts_within", 1, 100);
  }
  for (const XmlElement& servo : extension.children("servo_type")) readServoType(servo, robot);
  for (const XmlElement& pair : extension.children("ignore_contact")) {
    pair.accept({"first", "second"});
    robot.ignored_pairs.emplace_back(readReference(pair, "first"), readReference(pair, "second"));
  }
  if (const std::optional<XmlElement> api = extension.child("player_api")) readPlayerApi(*api, robot);
  readProperties(extension, "", robot);
}

}  // namespace murosimf::urdf
