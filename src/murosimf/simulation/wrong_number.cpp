#include "murosimf/simulation/wrong_number.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "murosimf/simulation/block_record.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// "nan", "inf" or the size of the first number of a value that is none; empty when all are.
template <class T>
std::string wrongNumber(const T& value) {
  double numbers[sizeof(T) / sizeof(double)];
  std::memcpy(numbers, &value, sizeof(T));
  for (const double number : numbers) {
    const bool good = std::abs(static_cast<float>(number)) < static_cast<float>(BlockRecord::kLargest);
    if (!good) return fmt::format("{:.3g}", std::abs(number));
  }
  return "";
}

}  // namespace

std::string wrongNumberOf(const World& world, LinkedWorld& linked, ObjectId robot) {
  const auto joints = world.members(robot, subset::kJoints);
  const Handle<double> q = linked.handle(robot, kJointPosition, subset::kJoints);
  const Handle<double> dq = linked.handle(robot, kJointVelocity, subset::kJoints);
  for (int j = 0; j < q.size(); ++j) {
    const std::string& path = world.path(joints[static_cast<std::size_t>(j)]);
    const std::string position = wrongNumber(q.get(j)), velocity = wrongNumber(dq.get(j));
    if (!position.empty()) return fmt::format("joint_position of {} is {}", path, position);
    if (!velocity.empty()) return fmt::format("joint_velocity of {} is {}", path, velocity);
  }
  const std::string base = wrongNumber(linked.handle(robot, kBasePose).get());
  if (!base.empty()) return fmt::format("a number of its base_pose is {}", base);
  const Handle<SpatialMotion<double>> moving = linked.handle(robot, kBaseVelocity);
  const std::string velocity = moving.valid() ? wrongNumber(moving.get()) : "";
  if (!velocity.empty()) return fmt::format("a number of its base_velocity is {}", velocity);
  return "all numbers are in order";
}

}  // namespace murosimf
