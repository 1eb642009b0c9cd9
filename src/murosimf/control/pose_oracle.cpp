#include "murosimf/control/pose_oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "murosimf/modules/camera/random_events.h"

namespace murosimf {

namespace {

enum Purpose : std::uint64_t { kX, kY, kHeading, kMiss, kOutage };

const PoseErrors& errorsOf(const PoseOracleSettings& settings, std::size_t robot) {
  return settings.errors[robot == 0 ? 0 : 1];
}

}  // namespace

const std::vector<ErrorParameter<PoseErrors>>& poseParameters() {
  using E = PoseErrors;
  static const std::vector<ErrorParameter<PoseErrors>> parameters = {
      {"position_noise", "m", 0, 10, &E::position_noise, "standard deviation along each axis"},
      {"heading_noise", "rad", 0, 4, &E::heading_noise, "standard deviation of the heading"},
      {"x_bias", "m", -10, 10, &E::x_bias, "always added, in the team's own frame"},
      {"y_bias", "m", -10, 10, &E::y_bias, "likewise"},
      {"heading_bias", "rad", -4, 4, &E::heading_bias, "likewise"},
      {"miss", "1", 0, 1, &E::miss, "probability that a pose is not told"},
      {"delay", "s", 0, 10, &E::delay, "from the truth to its arrival"},
      {"outage_rate", "1/s", 0, 10, &E::outage_rate, "how often phases begin in which nothing is told"},
      {"outage_length", "s", 0, 60, &E::outage_length, "how long such a phase lasts"}};
  return parameters;
}

PoseOracle::PoseOracle(std::vector<ToldRobot> robots, bool attacks_positive_x, const PoseOracleSettings& settings,
                       std::uint64_t seed, std::string_view robot, long control_period, double frame_length)
    : robots_(std::move(robots)),
      attacks_positive_x_(attacks_positive_x),
      settings_(settings),
      seed_(seed),
      name_(fmt::format("{}.localisation", robot)),
      control_period_(control_period),
      frame_length_(frame_length),
      waiting_(robots_.size()),
      told_(robots_.size()) {
  const double step = frame_length * static_cast<double>(control_period);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    waiting_[i].reserve(static_cast<std::size_t>(std::ceil(errorsOf(settings_, i).delay / step)) + 2);
}

/// Whether a pose is due in the control period that ends with this frame.
bool PoseOracle::isDue(long frame) const {
  if (settings_.period <= 0) return true;
  const auto ticks = [&](long end) {
    return std::floor((static_cast<double>(end) * frame_length_ - settings_.phase) / settings_.period + 1e-9);
  };
  return ticks(frame + 1) >= 0 && ticks(frame + 1) > ticks(frame + 1 - control_period_);
}

client::ToldPose PoseOracle::read(const SceneView& view, std::size_t robot, long frame) const {
  const PoseErrors& e = errorsOf(settings_, robot);
  const auto stream = [&](Purpose purpose) {
    return RandomStream(seed_, name_, static_cast<std::uint64_t>(robots_[robot].number) * 8 + purpose);
  };
  const auto step = static_cast<std::uint64_t>(frame + 1);
  const double time = static_cast<double>(frame + 1) * frame_length_;
  const Pose X_WB = view.bodyPose(robots_[robot].object, 0, frame);
  const double turn = attacks_positive_x_ ? 0 : kPi, side = attacks_positive_x_ ? 1 : -1;
  const double heading = atan2(X_WB.rotation.x.y, X_WB.rotation.x.x) + turn;
  client::ToldPose told;
  told.number = robots_[robot].number;
  told.time = time;
  told.valid =
      stream(kMiss).uniform(step) >= e.miss && !isOutage(stream(kOutage), time, e.outage_rate, e.outage_length);
  told.pose = {side * X_WB.translation.x + e.x_bias + e.position_noise * stream(kX).normal(step),
               side * X_WB.translation.y + e.y_bias + e.position_noise * stream(kY).normal(step),
               wrapAngle(heading + e.heading_bias + e.heading_noise * stream(kHeading).normal(step))};
  told.X_FB = {rotationZ(told.pose.heading - heading + turn) * X_WB.rotation,
               {told.pose.x, told.pose.y, X_WB.translation.z}};
  return told;
}

std::span<const client::ToldPose> PoseOracle::tell(const SceneView& view, long frame) {
  const bool due = isDue(frame);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    std::vector<Told>& waiting = waiting_[i];
    if (due) {
      const client::ToldPose pose = read(view, i, frame);
      if (pose.valid) waiting.push_back({pose, frame});
    }
    told_[i] = client::ToldPose{};
    told_[i].number = robots_[i].number;
    const long delay = std::lround(errorsOf(settings_, i).delay / frame_length_);
    const auto late =
        std::find_if(waiting.begin(), waiting.end(), [&](const Told& t) { return t.frame + delay > frame; });
    if (late == waiting.begin()) continue;
    told_[i] = std::prev(late)->pose;
    waiting.erase(waiting.begin(), late);
  }
  return told_;
}

void PoseOracle::archive(StateArchive& archive) {
  for (std::vector<Told>& waiting : waiting_) archive(waiting);
}

}  // namespace murosimf
