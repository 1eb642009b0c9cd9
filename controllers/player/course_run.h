#pragma once

/// @file How a robot of the role "runner" goes along a course: it plans a way around the obstacles that it knows, anew
/// every now and then, and walks after a point of it that lies ahead.
///
/// Slalom   the pole that is i-th by its distance along the course is passed on the side that the rules say: the other
///          side is a wall to the planner.

#include "ball_approach.h"
#include "situation.h"
#include "way_grid.h"

namespace murosimf::controllers {

class CourseRun {
 public:
  void start(const client::RobotDescription& robot);
  bool there() const { return course_.length > 0; }
  Decision step(const Situation& now);
  /// A new attempt begins.
  void restart() { until_plan_ = 0, passed_ = passed_before_ = 0; }
  /// The robot has fallen, and does not know any more where the obstacles are.
  void fall() { until_plan_ = 0, passed_before_ = passed_; }
  void archive(client::StateArchive& archive);

 private:
  void plan(const Situation& now);

  client::CourseDescription course_;
  WayGrid grid_;
  std::vector<Point> obstacles_C_;  ///< of the plan
  std::vector<CourseWall> walls_;   ///< same
  double until_plan_ = 0;           ///< [s]
  std::size_t passed_ = 0;          ///< obstacles behind the robot
  std::size_t passed_before_ = 0;   ///< of these, forgotten in a fall
};

}  // namespace murosimf::controllers
