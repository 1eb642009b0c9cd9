#include <fmt/format.h>

#include <cmath>

#include "murosimf/math/elementary.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf {

namespace {
constexpr int kRings = 3;  // of rays about the axis of a cone
}

std::vector<Vector3> RangeSensorMount::directions() const {
  std::vector<Vector3> all;
  for (const double angle : angles) {
    const SinCos<double> a = sincos(angle);
    all.push_back({a.cos, a.sin, 0});
  }
  if (!angles.empty()) return all;
  all.push_back({1, 0, 0});
  for (int ring = 1; half_angle > 0 && ring <= kRings; ++ring) {
    const SinCos<double> tilt = sincos(half_angle * ring / kRings);
    for (int i = 0; i < 6 * ring; ++i) {
      const SinCos<double> turn = sincos(2 * kPi * i / (6 * ring));
      all.push_back({tilt.cos, tilt.sin * turn.cos, tilt.sin * turn.sin});
    }
  }
  return all;
}

}  // namespace murosimf

namespace murosimf::urdf {
namespace {

constexpr int kMostRays = 4096;

const std::vector<std::string> kShared{"name",  "xyz",    "rpy",  "least", "largest",     "period",  "phase",
                                       "hides", "offset", "bias", "noise", "noise_share", "quantum", "delay"};

double notNegative(const XmlElement& element, const char* attribute, double fallback = 0) {
  const int before = element.diagnostics().errorCount();
  const double value = element.number(attribute, fallback);
  if (element.diagnostics().errorCount() == before && value < 0)
    element.errorAt(attribute, fmt::format("is {:g}, expected 0 or more", value));
  return value;
}

void readLimits(const XmlElement& element, RangeSensorMount& sensor) {
  const int before = element.diagnostics().errorCount();
  sensor.least = element.number("least", 0);
  sensor.largest = element.number("largest");
  sensor.period = element.number("period");
  sensor.phase = element.number("phase", 0);
  if (element.diagnostics().errorCount() != before) return;
  if (sensor.least < 0) element.errorAt("least", fmt::format("is {:g} m, expected 0 or more", sensor.least));
  if (!(sensor.largest > sensor.least))
    element.errorAt("largest",
                    fmt::format("is {:g} m, expected more than least, {:g} m", sensor.largest, sensor.least));
  if (!(sensor.period > 0)) element.errorAt("period", fmt::format("is {:g} s, expected more than 0", sensor.period));
  if (sensor.phase < 0) element.errorAt("phase", "is negative, expected the time of the first scan [s]");
}

RangeSensorPart readSensor(const XmlElement& element, const std::vector<std::string>& own, RobotPart& robot) {
  std::vector<std::string> attributes = kShared;
  attributes.insert(attributes.end(), own.begin(), own.end());
  element.accept(attributes, {"property"});
  RangeSensorPart part;
  RangeSensorMount& sensor = part.mount;
  sensor.name = readName(element);
  sensor.where = element.where();
  sensor.X_BS = element.pose();
  readLimits(element, sensor);
  sensor.errors = {element.number("offset", 0),         notNegative(element, "bias"),    notNegative(element, "noise"),
                   notNegative(element, "noise_share"), notNegative(element, "quantum"), notNegative(element, "delay")};
  for (const std::string& name : splitWords(element.has("hides") ? element.text("hides") : ""))
    part.hides.push_back({name, element.where("hides")});
  readProperties(element, sensor.name, robot);
  return part;
}

}  // namespace

RangeSensorPart readLaserScanner(const XmlElement& element, RobotPart& robot) {
  RangeSensorPart part = readSensor(element, {"rays", "first_angle", "last_angle"}, robot);
  const int before = element.diagnostics().errorCount();
  const int rays = element.integer("rays", 1, kMostRays);
  const double first = element.number("first_angle"), last = element.number("last_angle");
  if (element.diagnostics().errorCount() != before) return part;
  const char* const ends[] = {"first_angle", "last_angle"};
  for (const char* end : ends) {
    const double angle = element.number(end);
    if (std::fabs(angle) > 2 * kPi)
      element.errorAt(end, fmt::format("is {:g}, expected an angle in rad, from -2 pi to 2 pi", angle));
  }
  if (rays == 1 && first != last) element.errorAt("rays", "is 1, expected more between two angles");
  for (int i = 0; i < rays; ++i)
    part.mount.angles.push_back(rays == 1 ? first : first + (last - first) * i / (rays - 1));
  return part;
}

RangeSensorPart readDistanceSensor(const XmlElement& element, RobotPart& robot) {
  RangeSensorPart part = readSensor(element, {"half_angle"}, robot);
  const int before = element.diagnostics().errorCount();
  part.mount.half_angle = element.number("half_angle", 0);
  const double angle = part.mount.half_angle;
  if (element.diagnostics().errorCount() == before && !(angle >= 0 && angle < kPi / 2))
    element.errorAt("half_angle", fmt::format("is {:g} rad, expected 0 (one ray) or more, below pi/2", angle));
  return part;
}

}  // namespace murosimf::urdf
