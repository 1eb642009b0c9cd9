#include "murosimf/scene/scene.h"

#include <algorithm>
#include <utility>

#include "murosimf/math/elementary.h"

namespace murosimf {

double controlPeriod(const Scene& scene, const RobotSettings& robot) {
  return robot.control.period.given() ? *robot.control.period : *scene.simulation.control_period;
}

double controlDelay(const Scene& scene, const RobotSettings& robot) {
  return robot.control_delay.given() ? *robot.control_delay : *scene.simulation.control_delay;
}

client::FieldDescription fieldDescription(const Scene& scene) {
  const FieldSettings& field = scene.field;
  client::FieldDescription d;
  d.length = *field.length;
  d.width = *field.width;
  d.goal_width = *field.goal_width;
  d.goal_height = *field.goal_height;
  d.goal_depth = *field.goal_depth;
  d.post_radius = *field.post_radius;
  d.line_width = *field.line_width;
  d.border = *field.border;
  d.centre_circle_radius = *field.centre_circle_radius;
  d.goal_area_length = *field.goal_area_length;
  d.goal_area_width = *field.goal_area_width;
  d.penalty_area_length = *field.penalty_area_length;
  d.penalty_area_width = *field.penalty_area_width;
  d.penalty_mark_distance = *field.penalty_mark_distance;
  d.ball_radius = *scene.ball.radius;
  d.pole_radius = *field.pole_radius;
  d.pole_height = *field.pole_height;
  return d;
}

double ObstacleSettings::reach() const {
  return *shape == "box" ? 0.5 * sqrt(*length * *length + *width * *width) : *radius;
}

client::CourseDescription courseDescription(const Scene& scene, bool attacks_positive_x) {
  const CourseSettings& course = scene.course;
  client::CourseDescription d;
  d.length = *course.length, d.width = *course.width;
  d.X_FC = *course.pose;
  if (!attacks_positive_x) d.X_FC = {-d.X_FC.x, -d.X_FC.y, wrapAngle(d.X_FC.heading + kPi)};
  d.first_passed_on_left = *course.first_side == "left";
  d.slalom = *scene.referee.rules == "slalom";
  for (const ObstacleSettings& obstacle : scene.obstacles) {
    d.obstacle_radius = std::max(d.obstacle_radius, obstacle.reach());
    for (const ObstacleSettings* other = scene.obstacles.data(); other != &obstacle; ++other) {
      const double dx = obstacle.pose->x - other->pose->x, dy = obstacle.pose->y - other->pose->y;
      const double apart = sqrt(dx * dx + dy * dy);
      d.obstacle_spacing = d.obstacle_spacing > 0 ? std::min(d.obstacle_spacing, apart) : apart;
    }
  }
  return d;
}

const SurfacePairSettings* findSurfacePair(const Scene& scene, std::string_view a, std::string_view b) {
  if (b < a) std::swap(a, b);
  for (const SurfacePairSettings& pair : scene.surfaces)
    if (pair.first == a && pair.second == b) return &pair;
  return nullptr;
}

}  // namespace murosimf
