#include "game/match_setup.h"

#include <cmath>

namespace murosimf {

namespace {

Rules rulesNamed(const std::string& name) {
  if (name == "penalty_kicks") return Rules::kPenaltyKicks;
  if (name == "slalom") return Rules::kSlalom;
  return name == "obstacle_run" ? Rules::kObstacleRun : Rules::kMatch;
}

void addTrial(const Scene& scene, const World& world, MatchSettings& match) {
  match.rules = rulesNamed(*scene.referee.rules);
  match.attempts = *scene.referee.attempts;
  match.time_limit = *scene.referee.time_limit;
  match.scatter = *scene.referee.scatter;
  match.scatter_heading = *scene.referee.scatter_heading;
  match.seed = *scene.simulation.seed;
  const CourseSettings& course = scene.course;
  match.course = {*course.pose, *course.length, *course.width, *course.first_side == "left"};
  for (const ObstacleSettings& o : scene.obstacles)
    match.obstacles.push_back({world.find(o.path()), *o.pose, *o.mass > 0});
}

}  // namespace

MatchSettings matchSettings(const Scene& scene, const World& world) {
  MatchSettings match;
  addTrial(scene, world, match);
  match.field = fieldDescription(scene);
  match.ball = world.find("ball");
  match.ball_start = *scene.ball.position;
  match.red_attacks_positive_x = *scene.red.attacks_positive_x;
  for (const RobotSettings& robot : scene.robots) {
    MatchRobot& player = match.robots.emplace_back();
    player.object = world.find(robot.path());
    player.team = robot.team == "red" ? Team::kRed : Team::kBlue;
    player.number = robot.number;
    player.start = *robot.pose;
    if (robot.kickoff_own) player.kickoff_own = **robot.kickoff_own;
    if (robot.kickoff_other) player.kickoff_other = **robot.kickoff_other;
  }
  match.kickoff_team = *scene.referee.kickoff_team == "red" ? Team::kRed : Team::kBlue;
  match.kickoff_wait = *scene.referee.kickoff_wait;
  match.ball_moved = *scene.referee.ball_moved;
  match.pause_after_goal = *scene.referee.pause_after_goal;
  match.half_length = *scene.referee.half_length;
  match.duration = *scene.simulation.duration;
  match.control_period = std::lround(*scene.simulation.control_period / *scene.simulation.frame);
  return match;
}

}  // namespace murosimf
