#include "murosimf/soccer/course_referee.h"

#include <algorithm>
#include <numeric>

namespace murosimf {

CourseReferee::CourseReferee(const MatchSettings& match, Simulation& simulation) : TrialReferee(match, simulation) {
  order_.resize(match.obstacles.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  const auto along = [&](std::size_t i) {
    return inCourse({match.obstacles[i].start.x, match.obstacles[i].start.y, 0}).x;
  };
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  for (const MatchObstacle& obstacle : match.obstacles) {
    if (obstacle.movable) movable_.push_back(simulation.linked().handle(obstacle.object, kBasePose));
    if (attempter() < 0) continue;
    const ObjectId robot = match.robots[static_cast<std::size_t>(attempter())].object;
    watches_.emplace_back(simulation, robot, obstacle.object);
  }
  startAnew();
}

void CourseReferee::startAnew() {
  touching_.assign(match_.obstacles.size(), 0);
  passed_.assign(match_.obstacles.size(), 0);
}

std::optional<Outcome> CourseReferee::judge(Simulation& simulation) {
  if (attempter() < 0) return std::nullopt;
  countTouches(simulation);
  if (anyKnockedOver()) return Outcome::kKnocked;
  const Vector3 p_CB = inCourse(position(static_cast<std::size_t>(attempter()), simulation));
  if (match_.course.width > 0 && abs(p_CB.y) > 0.5 * match_.course.width) return Outcome::kLeft;
  for (std::size_t place = 0; match_.rules == Rules::kSlalom && place < order_.size(); ++place) {
    if (passesWrongly(place, p_CB)) return Outcome::kWrongSide;
  }
  if (p_CB.x > match_.course.length) return Outcome::kFinished;
  return std::nullopt;
}

void CourseReferee::countTouches(const Simulation& simulation) {
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    const bool touches = watches_[i].touches(simulation.frame());
    if (touches && touching_[i] == 0) countFault();
    touching_[i] = touches ? 1 : 0;
  }
}

bool CourseReferee::anyKnockedOver() const {
  return std::any_of(movable_.begin(), movable_.end(),
                     [](const Handle<Pose>& pose) { return pose.get().rotation.z.z < cos(kKnockedTilt); });
}

bool CourseReferee::passesWrongly(std::size_t place, const Vector3& p_CB) {
  const MatchObstacle& pole = match_.obstacles[order_[place]];
  const Vector3 p_CP = inCourse({pole.start.x, pole.start.y, 0});
  if (passed_[order_[place]] != 0 || p_CB.x < p_CP.x) return false;
  passed_[order_[place]] = 1;
  const bool on_left = match_.course.first_passed_on_left == (place % 2 == 0);
  return (p_CB.y > p_CP.y) != on_left;
}

Vector3 CourseReferee::inCourse(const Vector3& p_W) const {
  const PlanarPose& X_WC = match_.course.X_WC;
  return applyInverse(toPose(X_WC), p_W);
}

void CourseReferee::archive(StateArchive& archive) {
  TrialReferee::archive(archive);
  archive(touching_, passed_);
}

}  // namespace murosimf
