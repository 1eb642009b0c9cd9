// Focus rules: robots are simulated closely where the ball or another robot is near.

#include "murosimf/simulation/exchange_statistics.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

constexpr int kFar = 0, kNear = 1;

const std::string kWatched =
    "[referee]\nenabled = false\n[ball]\nposition = [3, 0]\n[robots.all]\nfile = \"robots/ks21.urdf\"\n"
    "[robots.red.1]\npose = [0, 0, 0]\nfocus = {ball = 0.8, robots = 0.6, margin = 0.3}\n"
    "[robots.red.2]\npose = [0, 2, 0]\n";

/// A game whose first robot has a rule; all robots hold themselves upright.
class Watched {
 public:
  explicit Watched(const std::string& text) : built_(text), simulation_(built_.simulation()) {
    for (const ObjectId robot : simulation_->participants().robots) {
      auto commands = simulation_->linked().handle(robot, kJointCommand, subset::kJoints);
      for (int j = 0; j < commands.size(); ++j) commands.set({0, 0, 0, 1, 0}, j);
    }
  }
  Simulation& simulation() { return *simulation_; }
  /// Level of the first robot after some frames.
  int levelAfter(int frames) {
    for (int i = 0; i < frames; ++i) simulation_->step();
    return simulation_->linked().levelOf(simulation_->participants().robots[0]);
  }
  void ballTo(double x) {
    simulation_->interventions().placeBody(simulation_->frame(), simulation_->participants().free_bodies[0],
                                           {x, 0, 0.07});
  }
  void otherTo(double y) {
    simulation_->interventions().placeRobot(simulation_->frame(), simulation_->participants().robots[1], {0, y, 0});
  }

 private:
  BuiltWorld built_;
  std::unique_ptr<Simulation> simulation_;
};

TEST(Focus, ARobotIsSimulatedCloselyWhileTheBallIsNear) {
  Watched game(kWatched);
  EXPECT_EQ(game.levelAfter(50), kFar);
  game.ballTo(0.75);
  EXPECT_EQ(game.levelAfter(30), kNear);
  game.ballTo(1.05);
  EXPECT_EQ(game.levelAfter(50), kNear) << "within the margin it stays";
  game.ballTo(1.15);
  EXPECT_EQ(game.levelAfter(30), kFar);
  game.ballTo(0.85);
  EXPECT_EQ(game.levelAfter(50), kFar) << "within the margin it does not come";
}

TEST(Focus, ARobotIsSimulatedCloselyWhileAnotherIsNear) {
  Watched game(kWatched);
  game.otherTo(0.55);
  EXPECT_EQ(game.levelAfter(30), kNear);
  game.otherTo(0.95);
  EXPECT_EQ(game.levelAfter(30), kFar);
}

TEST(Focus, WhatHasFallenGetsUpBeforeItGoesBack) {
  Watched game(kWatched);
  const ObjectId robot = game.simulation().participants().robots[0];
  game.ballTo(0.5);
  EXPECT_EQ(game.levelAfter(30), kNear);
  auto base = game.simulation().linked().handle(robot, kBasePose);
  const Pose upright = base.get();
  base.set({{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, {0, 0, 0.15}});
  game.ballTo(3);
  EXPECT_EQ(game.levelAfter(100), kNear);
  base.set(upright);
  EXPECT_EQ(game.levelAfter(30), kFar);
}

TEST(Focus, ReportsTellLevelsExchangesAndWhatWasFlattened) {
  Watched game(kWatched);
  ExchangeStatistics statistics(game.simulation());
  game.simulation().observe(&statistics);
  game.levelAfter(100);
  game.ballTo(0.5);
  game.levelAfter(99);
  auto base = game.simulation().linked().handle(game.simulation().participants().robots[0], kBasePose);
  Pose leaning = base.get();
  leaning.rotation = rotationY(0.02) * leaning.rotation;
  base.set(leaning);
  game.ballTo(3);
  game.levelAfter(101);
  ASSERT_EQ(statistics.robots().size(), 1U) << "the other robot has one level only";
  const ExchangeStatistics::Robot& robot = statistics.robots()[0];
  EXPECT_EQ(robot.exchanges, 2);
  EXPECT_EQ(robot.frames[0] + robot.frames[1], 300);
  EXPECT_NEAR(static_cast<double>(robot.frames[kNear]), 100, 10);
  EXPECT_NEAR(robot.largest_turn, 0.02, 0.002);
  EXPECT_LT(robot.largest_shift, 0.01);
}

TEST(Focus, RulesThatMakeNoSenseAreRefused) {
  const auto complaint = [](const std::string& line) {
    BuiltWorld built("[robots.red.1]\nfile = \"robots/ks21.urdf\"\npose = [0, 0, 0]\n" + line);
    const auto said = built.complaints();
    return said.empty() ? "" : said[0];
  };
  EXPECT_EQ(complaint("focus = \"kinematic_walking\"\n"),
            "4:9: robots.red.1: focus has the robot's usual motion \"kinematic_walking\"; expected another one");
  EXPECT_EQ(complaint("motion = \"kinematic_walking, multibody_dynamics@3\"\nfocus = \"simplified_dynamics\"\n"),
            "5:1: robots.red.1: focus chooses the motion by distances, and motion does by times; expected one of them");
  EXPECT_EQ(complaint("focus = \"multibody\"\n").substr(0, 61),
            "4:9: robots.red.1: unknown module \"multibody\" for motion; exp");
}

}  // namespace
}  // namespace murosimf::test
