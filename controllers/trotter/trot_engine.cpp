#include "trot_engine.h"

#include <cmath>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::trotter {

namespace {

constexpr double kRateShare = 0.4;   // of a new reading in the smoothed angular velocity
constexpr double kMostAstray = 0.3;  // [rad]: who is carried around need not turn back all the way
constexpr double kMostTilt = 0.35;   // [rad] that the legs lean against

/// wanted, reached from `now` with at most `largest_step`.
double approach(double now, double wanted, double largest_step) {
  return now + clamp(wanted - now, -largest_step, largest_step);
}

}  // namespace

void TrotEngine::feel(double dt, const TrunkSense& felt) {
  attitude_.observe(dt, felt.angular_velocity, felt.specific_force);
  filtered_rate_ = felt.angular_velocity * kRateShare + filtered_rate_ * (1 - kRateShare);
  astray_ = clamp(astray_ + (felt.angular_velocity.z - velocity_.omega) * dt, -kMostAstray, kMostAstray);
}

void TrotEngine::advance(double dt) {
  if (standing()) {
    phase_ = stepping_time_ = astray_ = 0;
    return;
  }
  stepping_time_ += dt;
  phase_ += dt / parameters.period;
  phase_ -= std::floor(phase_);

  const bool may_move = wants_to_trot_ && stepping_time_ >= parameters.start_time;
  const TrotCommand goal = may_move ? wanted_ : TrotCommand{};
  const TrotCommand &low = parameters.lowest, &high = parameters.highest, &change = parameters.largest_change;
  velocity_.vx = approach(velocity_.vx, clamp(goal.vx, low.vx, high.vx), change.vx * dt);
  velocity_.vy = approach(velocity_.vy, clamp(goal.vy, low.vy, high.vy), change.vy * dt);
  velocity_.omega = approach(velocity_.omega, clamp(goal.omega, low.omega, high.omega), change.omega * dt);

  const bool wants_steps = wants_to_trot_ || velocity_ != TrotCommand{};  // hooves are lifted as long as they travel
  amplitude_ = approach(amplitude_, wants_steps ? 1.0 : 0.0, dt / (2 * parameters.period));
}

/// The velocity with what brings the robot back to its heading; a robot that stands stays as it is.
TrotCommand TrotEngine::steered() const {
  TrotCommand v = velocity_;
  v.omega -= amplitude_ * parameters.heading_gain * astray_;
  return v;
}

JointAngles TrotEngine::step(double dt, const TrunkSense& felt) {
  feel(dt, felt);
  advance(dt);
  const TrunkMotion trunk{clamp(attitude_.roll(), -kMostTilt, kMostTilt),
                          clamp(attitude_.pitch(), -kMostTilt, kMostTilt), filtered_rate_.x, filtered_rate_.y};
  return trotPose(parameters, phase_, amplitude_, steered(), trunk);
}

void TrotEngine::archive(client::StateArchive& archive) {
  archive(wanted_, velocity_, wants_to_trot_, phase_, amplitude_, stepping_time_, astray_, attitude_, filtered_rate_);
}

}  // namespace murosimf::controllers::trotter
