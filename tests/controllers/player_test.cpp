#include "player/player.h"

#include <gtest/gtest.h>

#include <cstring>

#include "toy_game.h"

namespace murosimf::controllers {
namespace {

/// Runs until the robot has started a kick; false after the time limit [s].
bool runToKick(ToyGame& game, double limit) {
  while (game.time() < limit) {
    game.step();
    if (game.report(0).kicks_started > 0) return true;
  }
  return false;
}

struct Start {
  PlanarPose pose;
  Point ball;
};

class PlayerApproach : public testing::TestWithParam<Start> {};

TEST_P(PlayerApproach, StartsAKickWithTheBallAtTheFootAndTheGoalAhead) {
  ToyGame game({{0, 3, "striker", GetParam().pose}}, GetParam().ball);
  game.play_on = false;
  ASSERT_TRUE(runToKick(game, 45));
  const Point ball_R = transformedBack(game.pose(0), game.ball().p);
  EXPECT_GT(ball_R.x, 0.13);
  EXPECT_LT(ball_R.x, 0.21);
  EXPECT_GT(std::abs(ball_R.y), 0.03);
  EXPECT_LT(std::abs(ball_R.y), 0.10);
  EXPECT_LT(norm(game.ball().p - GetParam().ball), 0.03);  // it was not run over
  const double heading = game.pose(0).heading;
  const double at_goal_line = game.ball().p.y + tan(heading) * (2.25 - game.ball().p.x);
  EXPECT_LT(std::abs(heading), degrees(80));
  if (game.ball().p.x > 0.2) {
    EXPECT_LT(std::abs(at_goal_line), 0.70);
  }
}

INSTANTIATE_TEST_SUITE_P(Starts, PlayerApproach,
                         testing::Values(Start{{-1.0, 0.5, 0}, {0.3, 0}}, Start{{1.5, 0, 0}, {0.5, 0}},
                                         Start{{0.9, 0.9, -1.5}, {1.0, -0.5}}, Start{{1.0, -0.1, 3.0}, {0.8, -0.1}},
                                         Start{{0.0, -1.0, 1.5}, {1.2, 0.8}}, Start{{-0.2, 0.05, 0}, {0.35, 0}}));

TEST(Player, ScoresAlone) {
  ToyGame game({{0, 3, "striker", {-1.0, 0.5, 0}}}, {0.5, 0.3});
  for (const Point& ball : {Point{0.5, 0.3}, Point{1.0, -0.8}, Point{0.2, 0.9}}) {
    game.placeBall(ball);
    const int before = game.score(0);
    for (int i = 0; i < 6000 && game.score(0) == before; ++i) game.step();
    EXPECT_EQ(game.score(0), before + 1);
  }
  EXPECT_EQ(game.score(1), 0);
}

TEST(Player, FindsABallBehindItsBack) {
  ToyGame game({{0, 3, "striker", {0.5, 0, 0}}}, {-0.8, 0.2});
  game.play_on = false;
  EXPECT_TRUE(runToKick(game, 50));
}

TEST(Player, StandsStillUntilTheGameIsOn) {
  ToyGame game({{1, 3, "striker", {-0.85, 0, 0}}}, {0, 0});  // the other team's kick-off
  game.play_on = false;
  const PlanarPose start = game.pose(0);
  game.run(9.8);
  EXPECT_NEAR(between(start, game.pose(0)).x, 0, 1e-6);
  game.run(5);
  EXPECT_GT(between(start, game.pose(0)).x, 0.1);
}

TEST(Player, GoesWhenTheOpponentsHaveKickedOff) {
  ToyGame game({{1, 3, "striker", {-0.85, 0, 0}}}, {0, 0});
  game.play_on = false;
  const PlanarPose start = game.pose(0);
  game.run(3);
  game.placeBall({0.2, 0.3});
  game.run(4);
  EXPECT_GT(norm(Point{between(start, game.pose(0)).x, between(start, game.pose(0)).y}), 0.1);
}

TEST(Keeper, StaysInItsGoalAndBetweenBallAndGoal) {
  ToyGame game({{0, 1, "keeper", {-2.0, 0, 0}}}, {0, 1.0});
  game.play_on = false;
  for (const Point& ball : {Point{0, 1.0}, Point{-0.5, -1.2}, Point{1.5, 0.2}}) {
    game.placeBall(ball);
    game.run(15);
    const PlanarPose keeper = game.pose(0);
    EXPECT_LT(keeper.x, -1.7);
    EXPECT_GT(keeper.x, -2.25);
    EXPECT_LT(std::abs(keeper.y), 0.75);
    const double to_ball = direction(ball - Point{-2.25, 0}), to_keeper = direction(Point{keeper.x + 2.25, keeper.y});
    EXPECT_LT(std::abs(wrapAngle(to_ball - to_keeper)), degrees(16));
    EXPECT_LT(std::abs(wrapAngle(keeper.heading - direction(ball - Point{keeper.x, keeper.y}))), degrees(36));
  }
}

TEST(Keeper, ClearsABallThatLiesNearItsGoal) {
  ToyGame game({{0, 1, "keeper", {-2.0, 0, 0}}}, {-1.5, 0.4});
  game.play_on = false;
  game.run(30);
  EXPECT_GE(game.report(0).kicks_started, 1u);
  EXPECT_GT(game.ball().p.x, -0.9);
}

TEST(Team, OnlyOneGoesToTheBall) {
  ToyGame game({{0, 2, "defender", {-1.2, 0.5, 0}}, {0, 3, "striker", {-0.9, -0.4, 0}}}, {0.3, 0});
  game.play_on = false;
  double closest = 10;
  while (game.time() < 15 && game.report(1).kicks_started == 0) {
    game.step();
    const PlanarPose defender = game.pose(0);
    closest = std::min(closest, norm(game.ball().p - Point{defender.x, defender.y}));
  }
  EXPECT_EQ(game.report(1).kicks_started, 1u);
  EXPECT_EQ(game.report(0).kicks_started, 0u);
  EXPECT_GT(closest, 0.6);
}

/// Goals of a game of 300 s that begins with all robots `aside` [m].
int goalsOfAGame(double aside) {
  ToyGame game({{0, 1, "keeper", {-2.1, aside, 0}},
                {0, 2, "defender", {-1.1, .55 + aside, 0}},
                {0, 3, "striker", {-.3, aside, 0}},
                {1, 1, "keeper", {-2.1, aside, 0}},
                {1, 2, "defender", {-1.1, .55 + aside, 0}},
                {1, 3, "striker", {-.3, aside, 0}}},
               {0, 0});
  game.run(300);
  return game.score(0) + game.score(1);
}

// One game in fourteen has no goal.
TEST(Team, TwoTeamsScore) { EXPECT_GE(goalsOfAGame(0.02) + goalsOfAGame(0.03) + goalsOfAGame(0.05), 2); }

TEST(Player, ContinuesFromItsArchive) {
  ToyGame game({{0, 3, "striker", {-1.0, 0.5, 0}}}, {0.3, 0});
  game.run(7.37);
  client::StateArchive saved;
  game.player(0).archive(saved);
  ToyGame copy = ToyGame({{0, 3, "striker", {-1.0, 0.5, 0}}}, {0.3, 0});
  copy.continueFrom(game, saved);
  for (int i = 0; i < 800; ++i) {
    game.step(), copy.step();
    for (std::size_t j = 0; j < kJointCount; ++j) {
      ASSERT_EQ(game.commands(0).joints[j].position, copy.commands(0).joints[j].position) << i << " " << j;
    }
  }
  EXPECT_GE(copy.report(0).kicks_started, 1u);
}

TEST(Player, WithItsVisionStandsInTheDark) {
  const std::unique_ptr<client::ControlSoftware> player = makePlayer();
  const client::RobotDescription robot = makeRobot();
  player->start(robot);
  Puppet puppet;
  puppet.move(walkingPose({}, 0, 0, {}));
  const std::vector<std::uint8_t> black(640 * 480 * 3, 0);
  const std::vector<client::CameraPicture> pictures{{0, 0, 640, 480, black}};
  client::CommandFrame commands;
  commands.joints.resize(kJointCount);
  for (int i = 0; i < 20; ++i) {
    client::SensorFrame sensors;
    sensors.time = i * 0.01, sensors.joints = puppet.readings(), sensors.pictures = pictures;
    sensors.game.phase = client::GamePhase::kSet;
    player->step(sensors, commands);
  }
  EXPECT_FALSE(player->report().ball_known);
  EXPECT_NEAR(commands.joints[12].position, degrees(64.61), degrees(0.01));  // right knee of the walk-ready pose
  EXPECT_EQ(commands.joints[12].kp, 45);
  EXPECT_EQ(commands.joints[11].kp, 30);
}

TEST(Player, RefusesAnotherRobot) {
  client::RobotDescription robot = makeRobot();
  Player player(std::make_unique<ExactEyes>(nullptr));
  std::swap(robot.joints[9], robot.joints[10]);
  EXPECT_THROW(player.start(robot), std::invalid_argument);
  robot.joints.resize(20);
  EXPECT_THROW(player.start(robot), std::invalid_argument);
}

}  // namespace
}  // namespace murosimf::controllers
