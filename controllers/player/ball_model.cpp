#include "ball_model.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr double kNever = 1e9;             // age of a ball never seen [s]
constexpr double kRemembered = 3.0;        // a ball is known for so long after the last sight [s]
constexpr double kRememberedAtRest = 6.0;  // and for so long when it lay still
constexpr double kRestingSpeed = 0.1;      // slower than this counts as lying still [m/s]
constexpr double kGate = 13;               // squared error beyond which a sight is not believed (2 dof, 99.85 %)
constexpr double kSurpriseStep = 0.4;      // weight of one sight in the running mean
constexpr double kSurprising = 1.8;        // mean of half the squared error that tells of a push
constexpr double kPushVariance = 0.25;     // of the velocity after a push [m^2/s^2]
constexpr int kSightsWhenUnknown = 2, kSightsWhenKnown = 3;  // that a rival needs
constexpr double kFastest = 3.0;                             // no ball rolls faster [m/s]
constexpr double kRivalForgotten = 0.7;                      // after so long without a sight [s]
constexpr double kBearingDeviation = 0.02;                   // [rad]
constexpr double kFarthest = 15;                             // [m]

bool toSight(const BallPercept& percept, BallSight& sight) {
  sight.p_R = {percept.x, percept.y};
  const double distance = norm(sight.p_R);
  if (!(distance < kFarthest) || !(percept.deviation >= 0 && percept.deviation < 100)) return false;
  const double along = std::max(percept.deviation, 0.01), across = 0.01 + kBearingDeviation * distance;
  sight.along_variance = along * along;
  sight.across_variance = across * across;
  return true;
}

}  // namespace

void BallModel::start(const client::RobotDescription&) { forget(); }

void BallModel::forget() {
  filter_ = {};
  rival_ = {};
  age_ = kNever;
  surprise_ = 1;
}

bool BallModel::known() const {
  return age_ < kRemembered || (age_ < kRememberedAtRest && norm(filter_.velocity()) < kRestingSpeed);
}

Vector3 BallModel::position() const { return {filter_.position().x, filter_.position().y, 0}; }
Vector3 BallModel::velocity() const { return {filter_.velocity().x, filter_.velocity().y, 0}; }

void BallModel::move(const PlanarPose& increment, double dt) {
  if (!(std::fabs(increment.x) + std::fabs(increment.y) + std::fabs(increment.heading) < 10 && dt >= 0)) return;
  if (rival_.sights > 0) {
    rival_.last.p_R = transformedBack(increment, rival_.last.p_R);
    rival_.first = transformedBack(increment, rival_.first);
    rival_.since_first += dt, rival_.since_last += dt;
    if (rival_.since_last > kRivalForgotten) rival_ = {};
  }
  if (age_ >= kNever) return;
  age_ = std::min(age_ + dt, 0.1 * kNever);
  filter_.roll(dt);
  filter_.turn(increment);
}

void BallModel::observe(const Percepts& percepts) {
  bool agreed = false;
  const BallPercept* outlier = nullptr;
  BallSight sight;
  for (const BallPercept& percept : percepts.balls) {
    if (!toSight(percept, sight)) continue;
    const double squared_error = filter_.squaredError(sight);
    if (known() && squared_error < kGate) {
      agree(sight, squared_error);
      agreed = true;
    } else if (outlier == nullptr) {
      outlier = &percept;
    }
  }
  if (agreed) {
    age_ = 0;
    rival_ = {};
  } else if (outlier != nullptr && toSight(*outlier, sight)) {
    observeOutlier(sight);
  }
}

void BallModel::agree(const BallSight& sight, double squared_error) {
  surprise_ += kSurpriseStep * (0.5 * squared_error - surprise_);
  if (surprise_ > kSurprising) {
    filter_.disturb(kPushVariance);
    surprise_ = 1;
  }
  filter_.correct(sight);
}

void BallModel::observeOutlier(const BallSight& sight) {
  const double deviations =
      sqrt(sight.along_variance + sight.across_variance + rival_.last.along_variance + rival_.last.across_variance);
  const double reach = 2.5 * deviations + kFastest * rival_.since_last;
  if (rival_.sights == 0 || norm(sight.p_R - rival_.last.p_R) > reach) rival_ = {sight, sight.p_R, 0, 0, 0};
  rival_.last = sight;
  rival_.since_last = 0;
  ++rival_.sights;
  if (rival_.sights >= (known() ? kSightsWhenKnown : kSightsWhenUnknown)) takeOver();
}

void BallModel::takeOver() {
  // Velocity from the way between first and last sight, as far as it stands out of the noise of two positions.
  const double time = std::max(rival_.since_first, 0.02);
  const Point way = rival_.last.p_R - rival_.first;
  const double noise = rival_.last.along_variance + rival_.last.across_variance;
  const double variance = noise / (time * time), prior = 0.25;  // of a ball just kicked: 0.5 m/s
  const Point velocity = (prior / (prior + variance) / time) * way;
  filter_.begin(rival_.last, velocity, prior * variance / (prior + variance) + 0.01);
  age_ = 0;
  surprise_ = 1;
  rival_ = {};
}

void BallModel::archive(client::StateArchive& archive) { archive(filter_, rival_, age_, surprise_); }

}  // namespace murosimf::controllers
