#include "murosimf/game_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "murosimf/scene/module_choice.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// JSON has no NaN: what was never measured is null.
nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

double degrees(double angle) { return angle * 180 / kPi; }

std::string nameOf(const RobotStatistics& robot) {
  return fmt::format("robots.{}.{}", teamName(robot.team), robot.number);
}

std::string_view nameOf(MatchEvent::Kind kind) {
  switch (kind) {
    case MatchEvent::Kind::kKickoff:
      return "kick-off";
    case MatchEvent::Kind::kGoal:
      return "goal";
    case MatchEvent::Kind::kTouchLine:
      return "over the touch line";
    case MatchEvent::Kind::kGoalLine:
      return "over the goal line";
    case MatchEvent::Kind::kStuck:
      return "stuck";
    case MatchEvent::Kind::kHalfTime:
      return "half-time";
    case MatchEvent::Kind::kFinish:
      return "end";
    case MatchEvent::Kind::kAttempt:
      return "attempt";
  }
  return "";
}

nlohmann::ordered_json robotFigures(const RobotStatistics& robot) {
  return {{"robot", nameOf(robot)},
          {"distance_walked", robot.distance_walked},
          {"kicks", robot.kicks},
          {"touches", robot.ball.touches},
          {"shots", robot.ball.shots},
          {"shots_on_target", robot.ball.shots_on_target},
          {"saves", robot.ball.saves},
          {"goals", robot.ball.goals},
          {"own_goals", robot.ball.own_goals}};
}

nlohmann::ordered_json teamSums(const MatchResult& result, Team team) {
  BallCounts sum;
  for (const RobotStatistics& robot : result.robots) {
    if (robot.team != team) continue;
    sum.shots += robot.ball.shots;
    sum.shots_on_target += robot.ball.shots_on_target;
    sum.saves += robot.ball.saves;
    sum.own_goals += robot.ball.own_goals;
  }
  return {{"shots", sum.shots},
          {"shots_on_target", sum.shots_on_target},
          {"saves", sum.saves},
          {"own_goals", sum.own_goals}};
}

nlohmann::ordered_json perceptFigures(const PerceptResult& r, const std::string& robot) {
  return {{"robot", robot},
          {"pictures", r.pictures},
          {"pictures_with_ball", r.pictures_with_ball},
          {"ball_recall", number(r.recall)},
          {"ball_precision", number(r.precision)},
          {"ball_distance_error_median", number(r.distance_error_median)},
          {"pose_known_share", number(r.valid_share)},
          {"position_error_median", number(r.position_median)},
          {"position_error_90", number(r.position_90)},
          {"heading_error_median_deg", number(degrees(r.heading_median))},
          {"heading_error_90_deg", number(degrees(r.heading_90))}};
}

}  // namespace

void addMatch(nlohmann::ordered_json& report, const Referee& referee, const MatchStatistics& statistics) {
  const MatchResult result = statistics.result();
  report["score"] = {{"red", referee.score(Team::kRed)}, {"blue", referee.score(Team::kBlue)}};
  report["goals"] = nlohmann::ordered_json::array();
  for (const GoalRecord& goal : result.goals) {
    const bool known = goal.robot >= 0;
    report["goals"].push_back({{"time", goal.time},
                               {"team", teamName(goal.team)},
                               {"by", known ? nameOf(result.robots[static_cast<std::size_t>(goal.robot)]) : ""},
                               {"own_goal", goal.own_goal},
                               {"deliberate_kick", goal.deliberate}});
  }
  report["teams"] = {{"red", teamSums(result, Team::kRed)}, {"blue", teamSums(result, Team::kBlue)}};
  report["ball_in_play_share"] = result.in_play_share;
  for (const RobotStatistics& robot : result.robots) report["robots"].push_back(robotFigures(robot));
  for (const MatchEvent& event : referee.events()) {
    report["events"].push_back({{"time", event.time}, {"what", nameOf(event.kind)}, {"team", teamName(event.team)}});
  }
}

void addGameController(nlohmann::ordered_json& report, const GameBroadcast& broadcast) {
  const game_controller::GameLinkCounts counts = broadcast.link().counts();
  nlohmann::ordered_json& out = report["game_controller"];
  out = {{"sent", counts.sent},       {"dropped", counts.dropped},     {"heard", counts.heard},
         {"refused", counts.refused}, {"strangers", counts.strangers}, {"last_problem", counts.last_problem}};
  out["robots"] = nlohmann::ordered_json::array();
  for (const auto& [who, robot] : broadcast.link().robots()) {
    const game_controller::RobotStatus& s = robot.status;
    out["robots"].push_back({{"team", who.first},
                             {"player", who.second},
                             {"packets", robot.packets},
                             {"fallen", s.fallen},
                             {"x", number(static_cast<double>(s.x))},
                             {"y", number(static_cast<double>(s.y))},
                             {"heading", number(static_cast<double>(s.heading))}});
  }
}

void addTrial(nlohmann::ordered_json& report, const TrialReferee& referee) {
  nlohmann::ordered_json& trial = report["trial"];
  const std::vector<Attempt>& attempts = referee.attempts();
  double passed_time = 0;
  int faults = 0;
  trial["attempts"] = nlohmann::ordered_json::array();
  for (const Attempt& attempt : attempts) {
    trial["attempts"].push_back({{"outcome", nameOf(attempt.outcome)},
                                 {"passed", attempt.passed},
                                 {"time", attempt.time},
                                 {"faults", attempt.faults}});
    faults += attempt.faults;
    if (attempt.passed) passed_time += attempt.time;
  }
  const int passed = referee.passed();
  trial["passed"] = passed;
  trial["passed_share"] = number(passed / static_cast<double>(attempts.size()));
  trial["passed_time_mean"] = number(passed_time / passed);
  trial["faults"] = faults;
}

void addPercepts(nlohmann::ordered_json& report, const PerceptStatistics& statistics, const Simulation& simulation) {
  report["perception"]["all"] = perceptFigures(statistics.allTogether(), "all");
  for (const PerceptResult& result : statistics.results()) {
    report["perception"]["robots"].push_back(perceptFigures(result, simulation.world().path(result.robot)));
  }
}

void addExchanges(nlohmann::ordered_json& report, const Scene& scene, const ExchangeStatistics& statistics,
                  const Simulation& simulation) {
  for (const ExchangeStatistics::Robot& robot : statistics.robots()) {
    const std::string& path = simulation.world().path(robot.object);
    const auto settings = std::find_if(scene.robots.begin(), scene.robots.end(),
                                       [&](const RobotSettings& r) { return r.path() == path; });
    Diagnostics told_already;
    const MotionPlan plan = motionPlanOf(*settings, told_already, isOnWheels(simulation.world(), robot.object));
    nlohmann::ordered_json seconds;
    for (std::size_t level = 0; level < robot.frames.size(); ++level) {
      seconds[plan.motions[level]] = static_cast<double>(robot.frames[level]) * simulation.frameLength();
    }
    report["levels"].push_back({{"robot", path},
                                {"seconds", seconds},
                                {"exchanges", robot.exchanges},
                                {"largest_flattened_turn_deg", degrees(robot.largest_turn)},
                                {"largest_flattened_shift", robot.largest_shift}});
  }
}

void addIntegration(nlohmann::ordered_json& report, const IntegrationStatistics& statistics,
                    const Simulation& simulation) {
  for (const IntegrationStatistics::Robot& robot : statistics.robots()) {
    report["integration"].push_back({{"robot", simulation.world().path(robot.object)},
                                     {"substeps_mean", robot.substeps / static_cast<double>(robot.frames)},
                                     {"substeps_most", robot.most_substeps},
                                     {"largest_error", robot.largest_error},
                                     {"faulty_frames", robot.faulty_frames}});
  }
}

nlohmann::ordered_json contactFigures(const ContactStatistics::Counts& counts) {
  const auto mean = [&](long sum) {
    return static_cast<double>(sum) / static_cast<double>(std::max(counts.frames, 1L));
  };
  return {{"robot_pairs_near_mean", mean(counts.robots)},
          {"shape_pairs_near_mean", mean(counts.listed)},
          {"shape_pairs_tested_mean", mean(counts.tested)},
          {"points_mean", mean(counts.found)},
          {"points_most", counts.most_found},
          {"deepest", counts.deepest}};
}

nlohmann::ordered_json paceFigures(const PaceReport& pace) {
  return {{"frames", pace.frames},       {"deadline_misses", pace.misses}, {"worst_lateness", pace.worst_lateness},
          {"jitter_50", pace.jitter_50}, {"jitter_90", pace.jitter_90},    {"jitter_99", pace.jitter_99}};
}

}  // namespace murosimf
