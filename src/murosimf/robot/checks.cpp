#include "murosimf/robot/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace murosimf {
namespace {

constexpr std::size_t kLongestName = 100;

bool positive(double x) { return std::isfinite(x) && x > 0; }
bool notNegative(double x) { return std::isfinite(x) && x >= 0; }

}  // namespace

std::string shapeProblem(const BodyShape& shape) {
  const Vector3& half = shape.shape.half_size;
  if (!positive(half.x) || !positive(half.y) || !positive(half.z)) {
    return fmt::format("shape has the half sizes {:g}, {:g}, {:g} m, expected all to be positive", half.x, half.y,
                       half.z);
  }
  if ((shape.shape.kind == ShapeKind::kConvex) != (shape.hull != nullptr))
    return "shape and hull do not belong together, expected a hull of convex shapes and of no others";
  for (const float c : {shape.colour.red, shape.colour.green, shape.colour.blue}) {
    if (!(c >= 0.0F && c <= 1.0F)) return fmt::format("colour component is {:g}, expected 0 to 1", c);
  }
  return "";
}

std::string limitsProblem(const JointLimits& limits) {
  if (!(limits.lower <= limits.upper)) {
    return fmt::format("lower limit {:g} is above upper limit {:g}", limits.lower, limits.upper);
  }
  if (!(limits.largest_velocity > 0)) {
    return fmt::format("largest velocity is {:g}, expected more than 0", limits.largest_velocity);
  }
  if (!(limits.largest_torque > 0)) {
    return fmt::format("largest torque is {:g}, expected more than 0", limits.largest_torque);
  }
  return "";
}

std::string servoProblem(const ServoParameters& servo) {
  if (!positive(servo.stall_torque)) {
    return fmt::format("stall_torque is {:g} N m, expected more than 0", servo.stall_torque);
  }
  if (!positive(servo.no_load_speed)) {
    return fmt::format("no_load_speed is {:g} rad/s, expected more than 0", servo.no_load_speed);
  }
  if (!positive(servo.kp)) return fmt::format("kp is {:g} N m/rad, expected more than 0", servo.kp);
  if (!notNegative(servo.kd)) return fmt::format("kd is {:g} N m s/rad, expected 0 or more", servo.kd);
  if (!notNegative(servo.armature)) return fmt::format("armature is {:g} kg m^2, expected 0 or more", servo.armature);
  if (!notNegative(servo.resolution))
    return fmt::format("resolution is {:g} rad, expected 0 or more", servo.resolution);
  if (!notNegative(servo.backlash)) return fmt::format("backlash is {:g} rad, expected 0 or more", servo.backlash);
  return "";
}

std::string nameProblem(const std::string& name) {
  if (name.empty()) return "name is empty";
  if (name.size() > kLongestName)
    return "name " + quoted(name) + fmt::format(" is longer than {} characters", kLongestName);
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (std::all_of(name.begin(), name.end(), allowed)) return "";
  return "name " + quoted(name) + " holds something else than letters, digits, _ and -";
}

std::string deviceNameProblem(const std::string& name) {
  const auto prints = [](char c) { return c >= ' ' && c <= '~'; };
  const bool bare = !name.empty() && name.front() != ' ' && name.back() != ' ';
  if (bare && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), prints)) return "";
  return "device name is " + quoted(name) +
         fmt::format(", expected 1 to {} printable ASCII characters, no space at the ends", kLongestName);
}

std::optional<Vector3> unitAxis(const Vector3& axis) {
  const double largest = max(abs(axis.x), max(abs(axis.y), abs(axis.z)));
  if (!std::isfinite(axis.x) || !std::isfinite(axis.y) || !std::isfinite(axis.z) || largest == 0) return std::nullopt;
  Vector3 scaled;  // by the largest component first: a coordinate axis becomes exact, and nothing over- or underflows
  for (int i = 0; i < 3; ++i) scaled[i] = abs(axis[i]) < 1e-9 * largest ? 0.0 : axis[i] / largest;
  return scaled * (1 / norm(scaled));
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::string out = "\"";
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte >= 0x20 && byte < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
  }
  return out + (text.size() > kLongest ? "...\"" : "\"");
}

}  // namespace murosimf
