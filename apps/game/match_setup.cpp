#include "game/match_setup.h"

#include <cmath>

namespace murosimf {

MatchSettings matchSettings(const Scene& scene, const World& world) {
  MatchSettings match;
  match.field = fieldDescription(scene);
  match.ball = world.find("ball");
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
