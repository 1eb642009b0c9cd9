#include "murosimf/simulation/step_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace murosimf {

namespace {

template <class T>
const float* fetch(const float* source, T& value) {
  double numbers[sizeof(T) / sizeof(double)];
  for (double& number : numbers) number = static_cast<double>(*source++);
  std::memcpy(&value, numbers, sizeof(T));
  return source;
}

bool isNumber(float x) { return std::abs(x) < static_cast<float>(BlockRecord::kLargest); }

/// "nan", "inf" or the size of the first number of a value that is none; empty when all are.
template <class T>
std::string wrongNumber(const T& value) {
  double numbers[sizeof(T) / sizeof(double)];
  std::memcpy(numbers, &value, sizeof(T));
  for (const double number : numbers) {
    if (!isNumber(static_cast<float>(number))) return fmt::format("{:.3g}", std::abs(number));
  }
  return "";
}

}  // namespace

StepHistory::StepHistory(LinkedWorld& linked, ObjectId robot)
    : robot_(robot),
      base_(linked.handle(robot, kBasePose)),
      velocity_(linked.handle(robot, kBaseVelocity)),
      q_(linked.handle(robot, kJointPosition, subset::kJoints)),
      dq_(linked.handle(robot, kJointVelocity, subset::kJoints)),
      joints_(static_cast<std::size_t>(q_.size())),
      width_(BlockRecord::widthOf(joints_)) {}

StepHistory::Step StepHistory::step(int number) const {
  const long kept = count_ - size() + number;
  Step step;
  const float* next = fetch(fetch(slot(kept), step.X_WB), step.V_WB);
  step.X_WB.rotation = orthonormalized(step.X_WB.rotation);
  for (std::vector<double>* list : {&step.q, &step.dq, &step.command}) {
    list->assign(next, next + joints_);
    next += joints_;
  }
  std::memcpy(&step.time, next, sizeof(step.time));
  return step;
}

std::string StepHistory::fault(const World& world) const {
  const auto joints = world.members(robot_, subset::kJoints);
  for (std::size_t j = 0; j < joints_; ++j) {
    const std::string q = wrongNumber(q_.get(static_cast<int>(j))), dq = wrongNumber(dq_.get(static_cast<int>(j)));
    if (!q.empty()) return fmt::format("joint_position of {} is {}", world.path(joints[j]), q);
    if (!dq.empty()) return fmt::format("joint_velocity of {} is {}", world.path(joints[j]), dq);
  }
  const std::string base = wrongNumber(base_.get());
  if (!base.empty()) return fmt::format("a number of its base_pose is {}", base);
  const std::string velocity = velocity_.valid() ? wrongNumber(velocity_.get()) : "";
  if (!velocity.empty()) return fmt::format("a number of its base_velocity is {}", velocity);
  return "all numbers are in order";
}

}  // namespace murosimf
