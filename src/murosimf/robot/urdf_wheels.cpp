#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

constexpr double kTyreFriction = 0.7, kTyreStickSpeed = 0.002, kTyreCreepage = 0.03;
constexpr double kCastorFriction = 0.05;
constexpr double kStraight = 1e-3, kCentred = 1e-4;  // of an axle and its cylinder [rad, m]

double numberFrom(const XmlElement& element, const char* attribute, double fallback, bool zero_too) {
  const int before = element.diagnostics().errorCount();
  const double value = element.number(attribute, fallback);
  if (element.diagnostics().errorCount() == before && (value < 0 || (value == 0 && !zero_too)))
    element.errorAt(attribute, fmt::format("is {:g}, expected {}", value, zero_too ? "0 or more" : "more than 0"));
  return value;
}

/// The one shape of the link that touches, of a kind that rolls.
void readRim(const XmlElement& element, const LinkPart& link, bool cylinder_too, WheelMount& wheel) {
  const std::vector<BodyShape>& shapes = link.body.shapes;
  int touching = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!shapes[i].collides) continue;
    ++touching;
    wheel.shape = static_cast<int>(i);
  }
  const char* rims = cylinder_too ? "a cylinder or a sphere" : "a sphere";
  if (touching != 1)
    return element.error(fmt::format("stands in a link with {} shapes that collide, expected one, {}", touching, rims));
  const Shape& shape = shapes[static_cast<std::size_t>(wheel.shape)].shape;
  const Vector3& half = shape.half_size;
  const bool sphere = shape.kind == ShapeKind::kEllipsoid && half.x == half.y && half.y == half.z;
  if (!sphere && !(cylinder_too && shape.kind == ShapeKind::kCylinder))
    return element.error(fmt::format("stands in a link that collides as another shape, expected {}", rims));
  wheel.radius = half.x;
  wheel.p_BW = shapes[static_cast<std::size_t>(wheel.shape)].X_BS.translation;
}

void readSlip(const XmlElement& element, WheelMount& wheel, double friction) {
  wheel.friction = numberFrom(element, "friction", friction, true);
  wheel.stick_speed = numberFrom(element, "stick_speed", kTyreStickSpeed, false);
  wheel.creepage = numberFrom(element, "creepage", kTyreCreepage, true);
}

void refuseSecond(const XmlElement& element, const LinkPart& link) {
  if (link.wheels.empty()) return;
  element.error(fmt::format("is the second wheel or castor of its link, after the one in line {}, expected one",
                            link.wheels.front().where.line));
}

}  // namespace

WheelMount readWheel(const XmlElement& element, const LinkPart& link, RobotPart& robot) {
  element.accept({"name", "friction", "stick_speed", "creepage", "rollers", "roller_angle"}, {"property"});
  WheelMount wheel{.name = readName(element), .where = element.where()};
  refuseSecond(element, link);
  readRim(element, link, true, wheel);
  readSlip(element, wheel, kTyreFriction);
  if (element.truth("rollers", false)) wheel.feet = WheelFeet::kRollers;
  const int before = element.diagnostics().errorCount();
  wheel.roller_angle = element.number("roller_angle", 0);
  if (element.diagnostics().errorCount() == before && element.has("roller_angle")) {
    if (wheel.feet != WheelFeet::kRollers)
      element.errorAt("roller_angle", "stands at a wheel without rollers=\"true\"");
    if (!(std::fabs(wheel.roller_angle) < kPi / 2))
      element.errorAt("roller_angle", fmt::format("is {:g} rad, expected an angle between -pi/2 and pi/2: rollers "
                                                  "whose axles lie across its way drive nothing",
                                                  wheel.roller_angle));
  }
  readProperties(element, wheel.name, robot);
  return wheel;
}

WheelMount readCastor(const XmlElement& element, const LinkPart& link, RobotPart& robot) {
  element.accept({"name", "friction", "stick_speed"}, {"property"});
  WheelMount castor{.name = readName(element), .feet = WheelFeet::kCastor, .axle = kAxisZ, .where = element.where()};
  refuseSecond(element, link);
  readRim(element, link, false, castor);
  castor.friction = numberFrom(element, "friction", kCastorFriction, true);
  castor.stick_speed = numberFrom(element, "stick_speed", kTyreStickSpeed, false);
  readProperties(element, castor.name, robot);
  return castor;
}

namespace {

void checkAxle(const WheelMount& wheel, const BodyShape& rim, const Joint& joint, Diagnostics& diagnostics) {
  const Vector3 away = wheel.p_BW - joint.axis * dot(wheel.p_BW, joint.axis);
  if (norm(away) > kCentred)
    diagnostics.error(wheel.where, fmt::format("wheel {}: the centre of its shape is {:.4g} m away from the axis of "
                                               "joint {}, expected it on the axis",
                                               quoted(wheel.name), norm(away), quoted(joint.name)));
  if (rim.shape.kind != ShapeKind::kCylinder) return;
  const double tilt = norm(cross(rim.X_BS.rotation.z, joint.axis));
  if (tilt > kStraight)
    diagnostics.error(wheel.where,
                      fmt::format("wheel {}: its cylinder stands {:.4g} rad askew on the axis of joint {}, "
                                  "expected it about the axis",
                                  quoted(wheel.name), std::asin(std::min(tilt, 1.0)), quoted(joint.name)));
}

}  // namespace

void checkWheels(const LinkPart& link, const JointPart* joint, Diagnostics& diagnostics) {
  const bool turned = joint != nullptr && !joint->fixed && joint->joint.kind == JointKind::kRevolute;
  for (const WheelMount& wheel : link.wheels) {
    const bool castor = wheel.feet == WheelFeet::kCastor;
    if (castor == !turned) {
      if (turned) checkAxle(wheel, link.body.shapes[static_cast<std::size_t>(wheel.shape)], joint->joint, diagnostics);
      continue;
    }
    diagnostics.error(wheel.where,
                      castor ? fmt::format("castor {} stands in a link that joint {} turns, expected one that is fixed "
                                           "to another, or <wheel>",
                                           quoted(wheel.name), quoted(joint->joint.name))
                             : fmt::format("wheel {} stands in a link that no joint turns, expected one of type "
                                           "continuous, or <castor>",
                                           quoted(wheel.name)));
  }
}

}  // namespace murosimf::urdf
