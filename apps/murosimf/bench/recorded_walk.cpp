#include "murosimf/bench/recorded_walk.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "player/body_motion.h"

namespace murosimf {

namespace {

constexpr double kStanding = 0.7;    // [s] before the first step: the robot goes to its ready posture
constexpr double kLongest = 30;      // [s] until it walks as fast as it is to
constexpr double kTolerance = 1e-9;  // [rad] between a stride and the next one

double largestDifference(const controllers::JointAngles& a, const controllers::JointAngles& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) largest = std::max(largest, std::fabs(a[j] - b[j]));
  return largest;
}

}  // namespace

RecordedWalk::RecordedWalk(const controllers::WalkCommand& velocity, double period)
    : velocity_(velocity), stride_(std::lround(controllers::WalkParameters{}.period / period)) {
  using controllers::MotionRequest;
  controllers::BodyMotion motion;
  motion.startFrom({});
  const auto record = [&](const MotionRequest& wish) { rows_.push_back(motion.step(period, wish, {}, false)); };
  while (static_cast<double>(rows_.size()) * period < kStanding) record({});
  const MotionRequest walk{MotionRequest::Kind::kWalk, velocity, 0};
  do {
    record(walk);
    if (static_cast<double>(rows_.size()) * period > kLongest)
      throw std::logic_error("the gait does not reach the velocity that it is to be recorded at");
  } while (motion.velocity() != velocity);
  // Whatever else of the gait still grows has done so a stride later.
  for (long i = 0; i < stride_; ++i) record(walk);
  begin_ = static_cast<long>(rows_.size());
  for (long i = 0; i < 2 * stride_; ++i) record(walk);
  for (long i = 0; i < stride_; ++i) {
    const auto row = static_cast<std::size_t>(begin_ + i);
    if (largestDifference(rows_[row], rows_[row + static_cast<std::size_t>(stride_)]) > kTolerance)
      throw std::logic_error("the gait does not repeat after its stride");
  }
  rows_.resize(static_cast<std::size_t>(begin_ + stride_));
}

}  // namespace murosimf
