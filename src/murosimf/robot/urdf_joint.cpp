#include <fmt/format.h>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

void readAxis(const XmlElement& element, Joint& joint) {
  joint.axis = kAxisX;  // URDF's default
  const std::optional<XmlElement> axis = element.child("axis");
  if (!axis) return;
  axis->accept({"xyz"});
  const int before = axis->diagnostics().errorCount();
  const Vector3 direction = axis->vector("xyz");
  if (axis->diagnostics().errorCount() != before) return;
  if (const std::optional<Vector3> unit = unitAxis(direction)) {
    joint.axis = *unit;
  } else {
    axis->errorAt("xyz", "is the zero vector, expected a direction");
  }
}

/// A largest value: 0 in files of other programs often means that nobody knew it.
double readLargest(const XmlElement& limit, const char* attribute, const char* what) {
  const int before = limit.diagnostics().errorCount();
  const double value = limit.number(attribute);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (limit.diagnostics().errorCount() != before) return kNone;
  if (value < 0) limit.errorAt(attribute, fmt::format("is {:g}, expected more than 0", value));
  if (value == 0) {
    limit.warning(fmt::format("{} is 0: the joint could not {}; taken as no limit", attribute, what));
  }
  return value > 0 ? value : kNone;
}

void readLimits(const XmlElement& element, bool continuous, Joint& joint) {
  const std::optional<XmlElement> limit = continuous ? element.child("limit") : element.requiredChild("limit");
  if (!limit) return;
  const int before = limit->diagnostics().errorCount();
  limit->accept({"lower", "upper", "effort", "velocity"});
  joint.limits.largest_torque = readLargest(*limit, "effort", "push");
  joint.limits.largest_velocity = readLargest(*limit, "velocity", "move");
  if (continuous) return;
  joint.limits.lower = limit->number("lower", 0);
  joint.limits.upper = limit->number("upper", 0);
  if (limit->diagnostics().errorCount() == before) limit->check(limitsProblem(joint.limits));
}

void readDynamics(const XmlElement& element, Joint& joint) {
  const std::optional<XmlElement> dynamics = element.child("dynamics");
  if (!dynamics) return;
  dynamics->accept({"damping", "friction"});
  joint.damping = dynamics->number("damping", 0);
  joint.friction = dynamics->number("friction", 0);
  if (joint.damping < 0) dynamics->errorAt("damping", fmt::format("is {:g}, expected 0 or more", joint.damping));
  if (joint.friction < 0) dynamics->errorAt("friction", fmt::format("is {:g}, expected 0 or more", joint.friction));
}

/// Numbers that stand at the servo itself go before those of its type.
void readServo(const XmlElement& servo, const RobotPart& robot, Joint& joint) {
  const int before = servo.diagnostics().errorCount();
  servo.accept({"type", "kp", "kd", "armature", "resolution", "stall_torque", "no_load_speed", "backlash", "file"});
  const std::string type = servo.text("type");
  const auto found = robot.servo_types.find(type);
  if (found == robot.servo_types.end()) {
    if (!type.empty()) {
      servo.errorAt("type", "is " + quoted(type) + ", which no <servo_type> has" +
                                nearestKey(servo.diagnostics(), type, robot.servo_types));
    }
    return;
  }
  ServoParameters parameters = found->second;
  parameters.stall_torque = servo.number("stall_torque", parameters.stall_torque);
  parameters.no_load_speed = servo.number("no_load_speed", parameters.no_load_speed);
  parameters.kp = servo.number("kp", parameters.kp);
  parameters.kd = servo.number("kd", parameters.kd);
  parameters.armature = servo.number("armature", parameters.armature);
  parameters.resolution = servo.number("resolution", parameters.resolution);
  parameters.backlash = servo.number("backlash", parameters.backlash);
  parameters.file = servo.text("file", parameters.file);
  if (servo.diagnostics().errorCount() == before) servo.check(servoProblem(parameters));
  joint.servo = parameters;
}

void readExtension(const XmlElement& extension, JointPart& part, RobotPart& robot) {
  extension.accept({}, {"servo", "joint_sensor", "property"});
  if (const std::optional<XmlElement> servo = extension.child("servo")) {
    if (part.fixed) servo->error("stands at a joint of type fixed, expected revolute, continuous or prismatic");
    readServo(*servo, robot, part.joint);
  }
  if (const std::optional<XmlElement> sensor = extension.child("joint_sensor")) {
    sensor->accept({"resolution"});
    part.sensor_resolution = sensor->number("resolution", 0);
    if (*part.sensor_resolution < 0) sensor->errorAt("resolution", "is negative, expected 0 (exact) or more");
    if (part.fixed) sensor->error("stands at a joint of type fixed, which has no position");
  }
  readProperties(extension, part.joint.name, robot);
}

Reference readLinkName(const XmlElement& joint, const char* which) {
  const std::optional<XmlElement> element = joint.requiredChild(which);
  if (!element) return {"", joint.where()};
  element->accept({"link"});
  return readReference(*element, "link");
}

/// Elements of other programs that change what the joint does, or do not.
void readForeign(const XmlElement& element) {
  if (const auto mimic = element.child("mimic")) {
    mimic->error("joints that follow others are not supported; expected independent joints");
  }
  for (const char* name : {"calibration", "safety_controller"}) {
    if (const auto foreign = element.child(name)) foreign->warning("is ignored");
  }
}

}  // namespace

void readJoint(const XmlElement& element, RobotPart& robot) {
  element.accept({"name", "type"}, {"origin", "parent", "child", "axis", "limit", "dynamics", "murosimf", "mimic",
                                    "calibration", "safety_controller"});
  JointPart part;
  part.joint.name = readName(element);
  part.joint.where = element.where();
  part.parent = readLinkName(element, "parent");
  part.child = readLinkName(element, "child");
  if (const std::optional<XmlElement> origin = element.child("origin")) {
    origin->accept({"xyz", "rpy"});
    part.X_PJ = origin->pose();
  }
  const std::string type = element.text("type");
  part.fixed = type == "fixed";
  if (type == "prismatic") part.joint.kind = JointKind::kPrismatic;
  if (type == "revolute" || type == "continuous" || type == "prismatic") {
    readAxis(element, part.joint);
    readLimits(element, type == "continuous", part.joint);
    readDynamics(element, part.joint);
  } else if (!part.fixed && !type.empty()) {
    element.errorAt("type",
                    "is " + quoted(type) + ", expected revolute, continuous, prismatic or fixed" +
                        nearestName(element.diagnostics(), type, {"revolute", "continuous", "prismatic", "fixed"}));
  }
  readForeign(element);
  if (const std::optional<XmlElement> extension = element.child("murosimf")) readExtension(*extension, part, robot);
  if (!part.joint.name.empty()) robot.joints.push_back(std::move(part));
}

}  // namespace murosimf::urdf
