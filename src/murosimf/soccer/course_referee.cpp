#include "murosimf/soccer/course_referee.h"

#include <algorithm>

namespace murosimf {

CourseReferee::CourseReferee(const MatchSettings& match, Simulation& simulation) : TrialReferee(match, simulation) {
  for (const MatchObstacle& obstacle : match.obstacles) {
    poles_C_.push_back(inCourse({obstacle.start.x, obstacle.start.y, 0}));
    if (obstacle.movable) movable_.push_back(simulation.linked().handle(obstacle.object, kBasePose));
    if (attempter() < 0) continue;
    const ObjectId robot = match.robots[static_cast<std::size_t>(attempter())].object;
    watches_.emplace_back(simulation, robot, obstacle.object);
  }
  std::stable_sort(poles_C_.begin(), poles_C_.end(), [](const Vector3& a, const Vector3& b) { return a.x < b.x; });
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
  for (std::size_t pole = 0; match_.rules == Rules::kSlalom && pole < poles_C_.size(); ++pole) {
    if (passesWrongly(pole, p_CB)) return Outcome::kWrongSide;
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

bool CourseReferee::passesWrongly(std::size_t pole, const Vector3& p_CB) {
  const Vector3& p_CP = poles_C_[pole];
  if (passed_[pole] != 0 || p_CB.x < p_CP.x) return false;
  passed_[pole] = 1;
  const bool on_left = match_.course.first_passed_on_left == (pole % 2 == 0);
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
