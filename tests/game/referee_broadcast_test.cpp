#include <gtest/gtest.h>

#include <cmath>

#include "game/scripted_match.h"
#include "murosimf/soccer/match_statistics.h"

namespace murosimf::test {
namespace {

using client::GamePhase;

const std::vector<std::string> kBlind{"robots.all.cameras.head.module=\"none\"",
                                      "robots.all.cameras.chest.module=\"none\""};

void expectPlaced(const ScriptedRobot& robot, std::size_t frame, const PlanarPose& pose) {
  EXPECT_TRUE(robot.told[frame].placed);
  EXPECT_NEAR(robot.told[frame].placed_at.x, pose.x, 1e-9);
  EXPECT_NEAR(robot.told[frame].placed_at.y, pose.y, 1e-9);
  EXPECT_NEAR(wrapAngle(robot.told[frame].placed_at.heading - pose.heading), 0, 1e-9);
}

TEST(RefereeBroadcast, FirstSensorFrameAloneTellsWhereTheRobotWasPutInItsTeamsFrame) {
  ScriptedMatch match(kBlind, {});
  match.run(1.5);
  ASSERT_EQ(match.robots.size(), 6U);
  for (const auto& [name, robot] : match.robots) {
    EXPECT_EQ(robot->told.size(), 150U) << name;
    for (std::size_t i = 0; i < robot->told.size(); ++i) EXPECT_EQ(robot->told[i].placed, i == 0) << name << " " << i;
    EXPECT_EQ(robot->told[0].restart_count, 1U);
    EXPECT_EQ(robot->told[0].own_kickoff, name[0] == 'r');
    EXPECT_EQ(robot->told[0].phase, GamePhase::kSet);
    EXPECT_EQ(robot->told.back().phase, GamePhase::kPlaying);
    EXPECT_NEAR(robot->told[50].time_left - robot->told[51].time_left, 0.01, 1e-9);
  }
  expectPlaced(*match.robots["red2"], 0, {-1.10, 0.55, 0});
  expectPlaced(*match.robots["blue2"], 0, {-1.10, 0.55, 0});  // (1.10, -0.55, pi) turned
}

TEST(RefereeBroadcast, GoalBringsScoreAndKickoffPlacesOnceAndTheTruthWithThem) {
  ScriptedMatch match(kBlind, {});
  match.run(1.1);
  match.simulation->interventions().placeBody(match.simulation->frame(), match.settings.ball, {1.9, 0.5, 0.07},
                                              {2, 0, 0});
  match.run(3.2);  // goal, 2 s of pause, set
  ASSERT_EQ(match.referee->score(Team::kRed), 1);
  ASSERT_EQ(match.robots.size(), 6U);
  for (const auto& [name, robot] : match.robots) {
    int placements = 0;
    for (const client::GameInfo& game : robot->told) {
      placements += game.placed ? 1 : 0;
      EXPECT_EQ(game.restart_count == 2, placements == 2) << "the placement comes with the new restart";
    }
    EXPECT_EQ(placements, 2) << name;
    const client::GameInfo& now = robot->told.back();
    EXPECT_EQ(now.own_score, name[0] == 'r' ? 1 : 0);
    EXPECT_EQ(now.opponent_score, name[0] == 'r' ? 0 : 1);
    EXPECT_EQ(now.own_kickoff, name[0] == 'b');
    EXPECT_EQ(now.restart_count, 2U);
  }
  for (std::size_t i = 0; i < match.settings.robots.size(); ++i) {
    const PlanarPose wanted = kickoffPose(match.settings, match.settings.robots[i], Team::kBlue);
    const PlanarPose found = match.truePose(i);
    EXPECT_NEAR(found.x, wanted.x, 1e-6) << i;
    EXPECT_NEAR(found.y, wanted.y, 1e-6) << i;
    EXPECT_NEAR(wrapAngle(found.heading - wanted.heading), 0, 1e-6) << i;
  }
}

TEST(RefereeBroadcast, PlacementIsNoDistanceWalked) {
  ScriptedMatch match(kBlind, {});
  MatchStatistics statistics(*match.referee, *match.simulation, match.percepts.get());
  match.simulation->observe(&statistics);
  match.run(1.0);
  // Off the grid of half seconds and of control periods on purpose.
  match.simulation->interventions().placeRobot(1495, match.settings.robots[0].object, {-1.5, -0.8, 1});
  match.simulation->interventions().placeRobot(1777, match.settings.robots[1].object, {-1.5, 0.8, 1});
  match.run(2.0);
  for (const RobotStatistics& robot : statistics.result().robots) EXPECT_LT(robot.distance_walked, 1e-3);
  EXPECT_NEAR(match.truePose(0).x, -1.5, 1e-6);
  EXPECT_NEAR(statistics.result().playing_share, 2.0 / 3, 2e-3);
}

TEST(PerceptStatistics, KnownPoseErrorIsMeasuredForBothTeams) {
  ScriptedMatch match(kBlind, [](ScriptedRobot& robot, const client::SensorFrame& sensors) {
    if (sensors.game.placed) robot.report.pose = sensors.game.placed_at;
    if (sensors.game.placed) robot.report.pose.x += 0.3, robot.report.pose.y -= 0.4, robot.report.pose.heading += 6.4;
    robot.report.pose_valid = robot.told.size() > 150;
  });
  match.run(2.0);
  ASSERT_EQ(match.percepts->results().size(), 6U);
  for (const PerceptResult& r : match.percepts->results()) {
    EXPECT_NEAR(r.position_median, 0.5, 1e-3);
    EXPECT_NEAR(r.position_90, 0.5, 1e-3);
    EXPECT_NEAR(r.heading_median, 6.4 - 2 * kPi, 1e-3);
    EXPECT_EQ(r.playing_steps, 100);
    EXPECT_EQ(r.valid_steps, 50);
    EXPECT_EQ(r.pictures, 0);
    EXPECT_TRUE(std::isnan(r.recall));
  }
  EXPECT_EQ(match.percepts->allTogether().playing_steps, 600);
  EXPECT_NEAR(match.percepts->allTogether().position_90, 0.5, 1e-3);
}

/// Centre of what is orange in a picture without noise, as a percept. Another one in a corner, where the ball is not.
void seeOrange(ScriptedRobot& robot, const client::SensorFrame& sensors) {
  robot.report.percepts.clear();
  for (const client::CameraPicture& picture : sensors.pictures) {
    double n = 0, u = 0, v = 0;
    for (std::size_t i = 0; i < picture.bytes.size() / 3; ++i) {
      const int r = picture.bytes[3 * i], g = picture.bytes[3 * i + 1], b = picture.bytes[3 * i + 2];
      if (r < 2 * g || g < 3 * b || r < 60) continue;
      const std::size_t width = static_cast<std::size_t>(picture.width), column = i % width, row = i / width;
      n += 1, u += static_cast<double>(column), v += static_cast<double>(row);
    }
    if (n >= 12) robot.report.percepts.push_back({client::Percept::Kind::kBall, picture.camera, u / n, v / n, 1, 0.66});
    robot.report.percepts.push_back({client::Percept::Kind::kBall, picture.camera, 1, 1, 1, 3});
    robot.report.percepts.push_back({client::Percept::Kind::kPost, picture.camera, u / n, v / n, 1, 3});
  }
}

TEST(PerceptStatistics, OrangeBlobIsFoundAndTheFalseOneCounted) {
  // One robot, one ball .60 m before it.
  ScriptedMatch match(
      {"robots.all.cameras.head.noise=0", "robots.all.cameras.chest.noise=0", "robots.red.3.pose=[-0.60, 0, 0]"},
      seeOrange);
  match.run(0.5);
  const std::vector<PerceptResult> results = match.percepts->results();
  const int index = match.simulation->control()->indexOf(match.simulation->world().find("robots.red.3"));
  ASSERT_GE(index, 0);
  const PerceptResult& r = results[static_cast<std::size_t>(index)];
  EXPECT_EQ(r.pictures, 15);
  EXPECT_GT(r.pictures_with_ball, 4);
  EXPECT_EQ(r.recall, 1);
  EXPECT_EQ(r.ball_percepts, r.pictures + r.ball_percepts_right);
  EXPECT_EQ(r.ball_percepts_right, r.pictures_with_ball);
  EXPECT_NEAR(r.distance_error_median, 0.1, 1e-3);
}

/// What oracles tell of the ball, where a pinhole camera of the description's numbers would show it.
void repeatBalls(ScriptedRobot& robot, const client::SensorFrame& sensors) {
  robot.report.percepts.clear();
  for (const client::CameraSights& sights : sensors.sights) {
    if (sights.kind != client::ThingKind::kBall) continue;
    const client::CameraDescription& c = robot.description.cameras[static_cast<std::size_t>(sights.camera)];
    for (const client::SeenThing& ball : sights.things) {
      const double u = c.cx + c.fx * ball.p_C.x / ball.p_C.z, v = c.cy + c.fy * ball.p_C.y / ball.p_C.z;
      robot.report.percepts.push_back({client::Percept::Kind::kBall, sights.camera, u, v, 1, 0.6});
    }
  }
}

PerceptResult resultOfOracle(std::vector<std::string> errors) {
  for (const char* camera : {"head", "chest"})
    errors.insert(errors.begin(), std::string("robots.all.cameras.") + camera + ".module=oracle");
  errors.emplace_back("robots.red.3.pose=[-0.60, 0, 0]");
  ScriptedMatch match(errors, repeatBalls);
  match.run(4.0);
  const int index = match.simulation->control()->indexOf(match.simulation->world().find("robots.red.3"));
  return match.percepts->results()[static_cast<std::size_t>(index)];
}

TEST(PerceptStatistics, LooksOfOraclesCountAsPictures) {
  const PerceptResult exact = resultOfOracle({});
  EXPECT_GT(exact.pictures, 100);
  EXPECT_GT(exact.pictures_with_ball, 30);
  EXPECT_EQ(exact.recall, 1);
  EXPECT_EQ(exact.precision, 1);
  const PerceptResult wrong =
      resultOfOracle({"robots.all.cameras.head.ball_miss=0.3", "robots.all.cameras.chest.ball_miss=0.3",
                      "robots.all.cameras.head.ball_delay=0.1", "robots.all.cameras.chest.ball_false_rate=1"});
  EXPECT_NEAR(wrong.recall, 0.7, 0.12);
  EXPECT_LT(wrong.precision, 1);
  EXPECT_GT(wrong.precision, 0.7);
}

TEST(PerceptStatistics, BlindSoftwareHasNoRecall) {
  ScriptedMatch match({"robots.red.3.pose=[-0.60, 0, 0]"}, {});
  match.run(0.3);
  const PerceptResult all = match.percepts->allTogether();
  EXPECT_GT(all.pictures_with_ball, 0);
  EXPECT_EQ(all.recall, 0);
  EXPECT_TRUE(std::isnan(all.precision));
}

TEST(PerceptStatistics, KicksAreKnownOneStepLater) {
  ScriptedMatch match(kBlind, [](ScriptedRobot& robot, const client::SensorFrame&) {
    robot.report.kicks_started = static_cast<std::uint32_t>(robot.told.size());
  });
  match.run(0.1);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(match.percepts->kicksStarted(i), 9U);
}

}  // namespace
}  // namespace murosimf::test
