#include "team_ball.h"

#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr double kFresh = 1.0;         // messages younger than this count for decisions [s]
constexpr double kTold = 0.5;          // poses told of later than this tell no more than messages do [s]
constexpr double kPresent = 0.1;       // those told of within this are where a ball was just seen from [s]
constexpr double kOldest = 4.0;        // reports of older sights are not used [s]
constexpr double kTimeConstant = 1.0;  // of the weight [s]
constexpr double kNearDeviation = 0.1, kDeviationPerDistance = 0.1;  // of a reported ball: s0 [m], k
constexpr double kSameBall = 0.7;                                    // reports nearer than this mean one ball [m]

}  // namespace

bool cheapestToBall(int own_number, double own_cost, std::span<const client::TeamMessage> messages) {
  for (const client::TeamMessage& message : messages) {
    if (message.number == 0 || message.number == own_number) continue;
    if (message.cost_to_ball < own_cost) return false;
    if (message.cost_to_ball == own_cost && message.number < own_number) return false;
  }
  return true;
}

void TeamBall::start(const client::RobotDescription& robot) {
  reports_ = {};
  fresh_count_ = mate_count_ = 0;
  own_number_ = robot.number;
}

/// Null for no mate's number.
TeamBall::Report* TeamBall::reportOf(int number) {
  const bool mate = number >= 1 && number <= kLargestNumber && number != own_number_;
  return mate ? &reports_[static_cast<std::size_t>(number - 1)] : nullptr;
}

/// The ball was seen from where the mate is, whatever it believes.
void TeamBall::Report::take(const client::TeamMessage& heard) {
  message = heard, since = 0;
  if (!(told_age <= kPresent)) return;
  const Point ball = transformed(told, transformedBack(heard.pose, {heard.ball_x, heard.ball_y}));
  message.pose = told, message.ball_x = ball.x, message.ball_y = ball.y;
}

void TeamBall::observe(std::span<const client::TeamMessage> messages, double dt, std::span<const client::ToldPose> told,
                       double time) {
  for (Report& report : reports_) report.since += dt, report.told_age += dt;
  for (const client::ToldPose& pose : told) {
    Report* report = pose.valid ? reportOf(pose.number) : nullptr;
    if (report != nullptr) report->told = pose.pose, report->told_age = time - pose.time;
  }
  for (const client::TeamMessage& message : messages) {
    if (!std::isfinite(message.ball_x + message.ball_y + message.pose.x + message.pose.y)) continue;
    if (Report* report = reportOf(message.number)) report->take(message);
  }
  collectFresh();
}

void TeamBall::collectFresh() {
  fresh_count_ = mate_count_ = 0;
  for (const Report& report : reports_) {
    const bool heard = report.message.number > 0 && report.since <= kFresh;
    if (heard) fresh_[fresh_count_++] = report.message;
    if (report.told_age <= kTold) {
      mates_[mate_count_++] = {report.told.x, report.told.y};
    } else if (heard) {
      mates_[mate_count_++] = {report.message.pose.x, report.message.pose.y};
    }
  }
}

double TeamBall::Report::weight() const {
  if (message.number == 0 || !(age() < kOldest)) return 0;
  const double distance = norm(Point{message.ball_x - message.pose.x, message.ball_y - message.pose.y});
  const double spread = kDeviationPerDistance * distance;
  return exp(-age() / kTimeConstant) / (kNearDeviation * kNearDeviation + spread * spread);
}

const TeamBall::Report* TeamBall::best() const {
  const Report* best = nullptr;
  double largest = 0;
  for (const Report& report : reports_) {
    const double weight = report.weight();
    if (weight > largest) best = &report, largest = weight;
  }
  return best;
}

bool TeamBall::known() const { return best() != nullptr; }

double TeamBall::age() const {
  const Report* report = best();
  return report == nullptr ? 1e9 : report->age();
}

Point TeamBall::position() const {
  const Report* leader = best();
  if (leader == nullptr) return {};
  const Point p{leader->message.ball_x, leader->message.ball_y};
  Point sum{};
  double weights = 0;
  for (const Report& report : reports_) {
    const double weight = report.weight();
    const Point other{report.message.ball_x, report.message.ball_y};
    if (!(weight > 0) || norm(other - p) > kSameBall) continue;
    sum = sum + weight * other;
    weights += weight;
  }
  return (1 / weights) * sum;
}

void TeamBall::Report::archive(client::StateArchive& archive) {
  archive(message.number, message.pose, message.ball_x, message.ball_y, message.ball_age, message.cost_to_ball, since,
          told, told_age);
}

void TeamBall::archive(client::StateArchive& archive) {
  for (Report& report : reports_) archive(report);
  if (archive.loading()) collectFresh();
}

}  // namespace murosimf::controllers
