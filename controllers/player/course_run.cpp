#include "course_run.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

namespace {

constexpr double kPlanPeriod = 0.3;                   // [s]
constexpr double kAhead = 0.35;                       // of the point that is walked after [m]
constexpr double kSpeed = 0.22, kSidestep = 0.06;     // [m/s]
constexpr double kTurning = 1.8, kFastestTurn = 0.9;  // [1/s], [rad/s]
constexpr std::size_t kMostObstacles = 32;

WalkCommand walkAfter(const Point& p_R) {
  const double bearing = direction(p_R), ahead = std::max(0.0, 1 - std::fabs(bearing) / degrees(60));
  return {kSpeed * ahead, clamp(0.6 * p_R.y, -kSidestep, kSidestep) * ahead,
          clamp(kTurning * bearing, -kFastestTurn, kFastestTurn)};
}

}  // namespace

void CourseRun::start(const client::RobotDescription& robot) {
  course_ = robot.course;
  obstacles_C_.reserve(kMostObstacles), walls_.reserve(kMostObstacles);
  if (there()) grid_.start(course_);
}

Decision CourseRun::step(const Situation& now) {
  until_plan_ -= now.dt;
  if (until_plan_ <= 0) {
    plan(now);
    until_plan_ = kPlanPeriod;
  }
  const Point p_C = transformedBack(course_.X_FC, {now.X_FR.x, now.X_FR.y});
  const Point target_F = transformed(course_.X_FC, grid_.ahead(p_C, kAhead));
  const WalkCommand walk = walkAfter(transformedBack(now.X_FR, target_F));
  return {{MotionRequest::Kind::kWalk, walk, kRight}, HeadRequest::Kind::kBallAndField, "run"};
}

void CourseRun::plan(const Situation& now) {
  obstacles_C_.clear(), walls_.clear();
  for (const Point& p_R : now.course_R.first(std::min(now.course_R.size(), kMostObstacles)))
    obstacles_C_.push_back(transformedBack(course_.X_FC, transformed(now.X_FR, p_R)));
  std::sort(obstacles_C_.begin(), obstacles_C_.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const double own = transformedBack(course_.X_FC, {now.X_FR.x, now.X_FR.y}).x;
  passed_ = passed_before_;
  for (std::size_t i = 0; course_.slalom && i < obstacles_C_.size(); ++i) {
    const bool passes_left = course_.first_passed_on_left == ((passed_before_ + i) % 2 == 0);
    walls_.push_back({obstacles_C_[i], !passes_left});
    if (obstacles_C_[i].x < own) ++passed_;
  }
  grid_.plan(obstacles_C_, walls_);
}

void CourseRun::archive(client::StateArchive& archive) {
  archive(obstacles_C_, walls_, until_plan_, passed_, passed_before_);
  if (archive.loading() && there()) grid_.plan(obstacles_C_, walls_);
}

}  // namespace murosimf::controllers
