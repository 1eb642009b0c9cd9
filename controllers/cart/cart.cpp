#include "cart.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::cart {

namespace {

constexpr double kAcceleration = 1.2, kTurnAcceleration = 12;  // [m/s^2, rad/s^2]
constexpr double kBackingTime = 0.5, kBackingSpeed = 0.15;     // [s, m/s]

double stepped(double from, double to, double largest) { return from + std::clamp(to - from, -largest, largest); }

}  // namespace

void Cart::start(const client::RobotDescription& robot) {
  period_ = robot.control_period;
  plan_ = readCartPlan(robot.role);
  drive_ = WheelDrive(robot);
  square_ = SquareDriver(plan_.edge, plan_.speed, drive_.omnidirectional());
  bumpers_ = robot.touch_mounts;
  guard_.describe(robot.range_sensors);
  play_.describe(robot, drive_.omnidirectional());
}

void Cart::step(const client::SensorFrame& sensors, client::CommandFrame& commands) {
  BaseMotion way;
  if (wheel_angles_.empty()) {
    wheel_angles_.resize(drive_.wheelCount());
    drive_.wayOf(sensors.joints, wheel_angles_);
  } else {
    way = drive_.wayOf(sensors.joints, wheel_angles_);
  }
  odometry_.advance(way);
  guard_.see(sensors.scans);
  play_.see(sensors, way);
  BaseMotion velocity = wanted(sensors);
  if (plan_.task == CartTask::kPlay && backsOff(sensors, velocity)) report_.activity = "back off";
  ramp(velocity);
  drive_.command(velocity_, commands.joints);
  tell();
}

BaseMotion Cart::wanted(const client::SensorFrame& sensors) {
  if (plan_.task == CartTask::kSquare) {
    report_.activity = square_.done() ? "rest" : "square";
    return square_.velocityAt(odometry_);
  }
  if (plan_.task == CartTask::kDrive) return report_.activity = "drive", plan_.velocity;
  if (plan_.task == CartTask::kRest) return report_.activity = "rest", BaseMotion{};
  const BaseMotion velocity = play_.play(sensors, guard_);
  report_.activity = play_.activity();
  return velocity;
}

/// A bumper that presses on the ball is meant to.
bool Cart::backsOff(const client::SensorFrame& sensors, BaseMotion& velocity) {
  const std::optional<GroundPoint> ball = play_.ball();
  for (std::size_t i = 0; i < std::min(sensors.touches.size(), bumpers_.size()); ++i) {
    if (sensors.touches[i] == 0) continue;
    const Vector3& p = bumpers_[i].centre;
    const bool on_ball = ball && (ball->x - p.x) * (ball->x - p.x) + (ball->y - p.y) * (ball->y - p.y) < 0.15 * 0.15;
    if (on_ball) continue;
    backing_ = kBackingTime;
    back_to_ = atan2(p.y, p.x);
  }
  if (backing_ <= 0 || sensors.game.phase != client::GamePhase::kPlaying) return false;
  backing_ -= period_;
  const SinCos<double> a = sincos(back_to_);
  velocity = {-kBackingSpeed * a.cos, drive_.omnidirectional() ? -kBackingSpeed * a.sin : 0, 0};
  return true;
}

void Cart::ramp(const BaseMotion& wanted) {
  velocity_.x = stepped(velocity_.x, wanted.x, kAcceleration * period_);
  velocity_.y = stepped(velocity_.y, wanted.y, kAcceleration * period_);
  velocity_.turn = stepped(velocity_.turn, wanted.turn, kTurnAcceleration * period_);
}

void Cart::tell() {
  const bool plays = plan_.task == CartTask::kPlay;
  const Place& place = plays ? play_.pose() : odometry_;
  report_.pose = {place.x, place.y, wrapped(place.heading)};
  report_.pose_valid = plays && play_.placed();
  const std::optional<GroundPoint> ball = play_.ball();
  report_.ball_known = ball.has_value();
  if (ball) report_.ball_x = ball->x, report_.ball_y = ball->y;
}

void Cart::archive(client::StateArchive& archive) {
  archive(guard_, play_, square_, wheel_angles_, odometry_, velocity_, backing_, back_to_);
}

std::unique_ptr<client::ControlSoftware> makeCart() { return std::make_unique<Cart>(); }

}  // namespace murosimf::controllers::cart
