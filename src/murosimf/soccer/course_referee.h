#pragma once

/// @file The referee of a slalom and of an obstacle run: a robot goes along a course, from the start line to the finish
/// line, and time counts.
///
/// Frame C     of the course: origin in the middle of the start line, x along the way, y to its left.
/// Finish      The robot's base is behind the finish line, x > length.
/// Strip       A course may have a width; when the base is beyond its edge the attempt ends.
/// Touch       A shape of the robot that collides is less than kTouchGap from one of an obstacle, at any level of
///             detail. A fault each time that it begins; in a slalom it makes the attempt fail.
/// Slalom      The poles are passed in the order of their x, the first on the side that the course names, the next ones
///             on alternate sides; a wrong side ends the attempt.
/// Obstacles   knocked over (turned by more than kKnockedTilt) end the attempt.

#include "murosimf/soccer/touch_watch.h"
#include "murosimf/soccer/trial_referee.h"

namespace murosimf {

inline constexpr double kKnockedTilt = kPi / 4;  // [rad]

class CourseReferee final : public TrialReferee {
 public:
  CourseReferee(const MatchSettings& match, Simulation& simulation);

  void archive(StateArchive& archive) override;

 private:
  std::optional<Outcome> judge(Simulation& simulation) override;
  void startAnew() override;
  void countTouches(const Simulation& simulation);
  bool anyKnockedOver() const;
  /// Whether the pole's line is crossed now on the wrong side.
  bool passesWrongly(std::size_t pole, const Vector3& p_CB);
  Vector3 inCourse(const Vector3& p_W) const;

  std::vector<Vector3> poles_C_;       // where the obstacles stood at first, by their x
  std::vector<Handle<Pose>> movable_;  // poses of the obstacles that may be knocked over
  std::vector<TouchWatch> watches_;    // as MatchSettings::obstacles
  // Of the attempt.
  std::vector<char> touching_;  // as MatchSettings::obstacles
  std::vector<char> passed_;    // as poles_C_
};

}  // namespace murosimf
