#include "murosimf/simulation/step_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace murosimf {

namespace {

constexpr std::size_t kPoseNumbers = 12, kTwistNumbers = 6, kJointNumbers = 3;
constexpr std::size_t kTimeNumbers = sizeof(double) / sizeof(float);  // which stays double: behind all others

constexpr std::size_t kTogether = 4;  // numbers that are written at once

template <class T>
float* keep(const T& value, float* target) {
  double numbers[sizeof(T) / sizeof(double)];
  std::memcpy(numbers, &value, sizeof(T));
  for (const double number : numbers) *target++ = static_cast<float>(number);
  return target;
}
/// Writes past the caches: a step is read again only when something went wrong, and would push out what the next frame
/// needs. Both places at multiples of 16 bytes. Who reads from another thread has synchronised with this one by a
/// locked instruction, behind which such writes are seen.
void putAway(const std::vector<float>& step, float* target) {
#ifdef __SSE__
  for (std::size_t i = 0; i < step.size(); i += kTogether) _mm_stream_ps(target + i, _mm_load_ps(step.data() + i));
#else
  std::copy(step.begin(), step.end(), target);
#endif
}
template <class T>
const float* fetch(const float* source, T& value) {
  double numbers[sizeof(T) / sizeof(double)];
  for (double& number : numbers) number = static_cast<double>(*source++);
  std::memcpy(&value, numbers, sizeof(T));
  return source;
}

bool isNumber(float x) { return std::abs(x) < static_cast<float>(StepHistory::kLargest); }

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
      command_(linked.handle(robot, kJointCommand, subset::kJoints)),
      joints_(static_cast<std::size_t>(q_.size())),
      width_((kPoseNumbers + kTwistNumbers + kJointNumbers * joints_ + kTimeNumbers + kTogether - 1) / kTogether *
             kTogether) {}

bool StepHistory::record(double time) {
  thread_local std::vector<float> written;
  written.resize(width_);
  float* const first = written.data();
  float* next = keep(base_.get(), first);
  next = keep(velocity_.valid() ? velocity_.get() : SpatialMotion<double>{}, next);
  const LaneValues<double> q = q_.values(), dq = dq_.values();
  const LaneValues<ServoCommand> command = command_.values();
  bool good = true;
  for (std::size_t j = 0; j < joints_; ++j) next[j] = static_cast<float>(q.get(static_cast<int>(j)));
  for (std::size_t j = 0; j < joints_; ++j) next[joints_ + j] = static_cast<float>(dq.get(static_cast<int>(j)));
  for (const float* number = first; number < next + 2 * joints_; ++number) good &= isNumber(*number);
  next += 2 * joints_;
  for (std::size_t j = 0; j < joints_; ++j) next[j] = static_cast<float>(command.get(static_cast<int>(j)).position);
  std::memcpy(next + joints_, &time, sizeof(time));
  putAway(written, slot(count_++));
  return good;
}

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
