// Trials are judged as their rules say, whoever moves the robot: here it is put from place to place.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "game/game.h"
#include "game/game_observers.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/checkpoint.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {
namespace {

using client::GamePhase;

/// A trial whose robots nobody controls.
struct Trial {
  explicit Trial(const std::string& name, std::vector<std::string> overrides = {}) {
    overrides.insert(overrides.end(),
                     {"robots.all.control=none", "robots.all.cameras.head=none", "robots.all.cameras.chest=none"});
    scene = readScenario("scenarios/" + name + ".toml", overrides, diagnostics);
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    watch = std::make_unique<GameObservers>(*scene, *simulation);
  }
  const TrialReferee& referee() const { return *watch->trial(); }
  const std::vector<Attempt>& attempts() const { return referee().attempts(); }
  ObjectId robot(const char* path = "robots.red.1") const { return simulation->world().find(path); }
  void run(double seconds) {
    for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
  }
  void runUntilPlaying() {
    while (referee().phase() != GamePhase::kPlaying) simulation->step();
  }
  /// Puts the robot there and lets the referee look at it.
  void put(double x, double y, const char* path = "robots.red.1") {
    simulation->interventions().placeRobot(simulation->frame(), robot(path), {x, y, 0});
    run(0.04);
  }
  void shoot(double x, double y, double speed_x, double speed_y) {
    const Vector3 place{x, y, *scene->ball.radius};
    simulation->interventions().placeBody(simulation->frame(), robot("ball"), place, {speed_x, speed_y, 0});
  }

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<GameObservers> watch;
};

/// Places beside the three poles of scenarios/slalom.toml, and behind the finish line.
void passPoles(Trial& trial, double first_y, double second_y, double third_y) {
  trial.put(-1.2, first_y), trial.put(-0.7, first_y);
  trial.put(-0.4, second_y), trial.put(0.05, second_y);
  trial.put(0.4, third_y), trial.put(0.8, third_y);
  trial.put(1.85, 0);
}

TEST(Slalom, IsFinishedByWhoPassesThePolesOnAlternateSides) {
  for (const char* level : {"kinematic", "full"}) {
    Trial trial("slalom", {std::string("robots.all.level=") + level});
    trial.runUntilPlaying();
    passPoles(trial, 0.5, -0.5, 0.5);
    ASSERT_EQ(trial.attempts().size(), 1U);
    EXPECT_EQ(trial.attempts()[0].outcome, Outcome::kFinished);
    EXPECT_TRUE(trial.attempts()[0].passed);
    EXPECT_EQ(trial.attempts()[0].faults, 0);
    EXPECT_NEAR(trial.attempts()[0].time, 7 * 0.04, 0.05);
    EXPECT_EQ(trial.referee().phase(), GamePhase::kFinished);
  }
}

TEST(Slalom, APoleOnTheWrongSideEndsTheAttempt) {
  Trial right("slalom", {"course.first_side=right"}), left("slalom");
  right.runUntilPlaying(), left.runUntilPlaying();
  passPoles(right, 0.5, -0.5, 0.5), passPoles(left, 0.5, 0.5, 0.5);
  ASSERT_EQ(right.attempts().size(), 1U);
  ASSERT_EQ(left.attempts().size(), 1U);
  EXPECT_EQ(right.attempts()[0].outcome, Outcome::kWrongSide);
  EXPECT_EQ(left.attempts()[0].outcome, Outcome::kWrongSide);
  EXPECT_FALSE(left.attempts()[0].passed);
  EXPECT_GT(left.attempts()[0].time, right.attempts()[0].time);
}

TEST(Slalom, TouchingAPoleIsAFaultEachTimeItBegins) {
  for (const char* level : {"kinematic", "full"}) {
    Trial trial("slalom", {std::string("robots.all.level=") + level});
    trial.runUntilPlaying();
    trial.put(-1.2, 0.5), trial.put(-0.75, 0.5), trial.put(-0.75, 0.15), trial.put(-0.75, 0.5), trial.put(-0.75, 0.15);
    EXPECT_EQ(trial.referee().scoreText(), "attempt 1 of 1, 2 faults") << level;
    passPoles(trial, 0.5, -0.5, 0.5);
    ASSERT_EQ(trial.attempts().size(), 1U) << level;
    EXPECT_EQ(trial.attempts()[0].outcome, Outcome::kFinished) << level;
    EXPECT_EQ(trial.attempts()[0].faults, 2) << level;
    EXPECT_FALSE(trial.attempts()[0].passed) << level;
  }
}

TEST(ObstacleRun, WhoLeavesTheStripHasFailed) {
  Trial trial("obstacle_run");
  trial.runUntilPlaying();
  trial.put(0.74, -2.5);
  EXPECT_TRUE(trial.attempts().empty());
  trial.put(0.76, -2.5);
  ASSERT_EQ(trial.attempts().size(), 1U);
  EXPECT_EQ(trial.attempts()[0].outcome, Outcome::kLeft);
}

TEST(ObstacleRun, WhoKnocksABoxOverHasFailed) {
  Trial trial("obstacle_run");
  trial.runUntilPlaying();
  const ObjectId box = trial.robot("obstacles.random_1");
  ASSERT_TRUE(box.valid());
  auto pose = trial.simulation->linked().handle(box, kBasePose);
  const Vector3 stood = pose.get().translation;
  trial.run(1);
  EXPECT_LT(norm(pose.get().translation - stood), 2e-3) << "a box that nobody touches stands";
  for (int i = 0; i < 400 && trial.attempts().empty(); ++i) {
    const Vector3 top = pose.get() * Vector3{0, 0, 0.4};
    trial.simulation->interventions().push(trial.simulation->frame(), box, 0, top, {0, 12, 0});
    trial.simulation->step();
  }
  trial.run(1.0);
  ASSERT_EQ(trial.attempts().size(), 1U);
  EXPECT_EQ(trial.attempts()[0].outcome, Outcome::kKnocked);
}

TEST(ObstacleRun, BoxesStandOnFiveDifferentSitesAndAtMostTwoAbreast) {
  std::vector<std::vector<double>> layouts;
  for (const char* seed : {"1", "2", "3", "4", "5", "6"}) {
    Diagnostics diagnostics;
    const Scene scene =
        readScenario("scenarios/obstacle_run.toml", {std::string("simulation.seed=") + seed}, diagnostics).value();
    ASSERT_EQ(scene.obstacles.size(), 5U);
    std::map<long, int> abreast;
    std::set<std::pair<long, long>> sites;
    std::vector<double> layout;
    for (const ObstacleSettings& box : scene.obstacles) {  // the strip goes along y of the field
      const double along = (box.pose->y + 3.0) / 1.5, across = (box.pose->x + 0.75) / 0.375;
      EXPECT_NEAR(along, std::round(along), 1e-9);
      EXPECT_NEAR(across, std::round(across), 1e-9);
      ++abreast[std::lround(along)];
      sites.insert({std::lround(along), std::lround(across)});
      layout.push_back(box.pose->x), layout.push_back(box.pose->y);
    }
    EXPECT_EQ(sites.size(), 5U);
    for (const auto& [along, count] : abreast) EXPECT_LE(count, 2);
    layouts.push_back(layout);
  }
  std::sort(layouts.begin(), layouts.end());
  EXPECT_GE(std::unique(layouts.begin(), layouts.end()) - layouts.begin(), 4) << "seeds choose different sites";
}

TEST(PenaltyKick, EndsWithAGoalBesideItOrWhenTheTimeIsUp) {
  Trial trial("penalty_kick", {"referee.attempts=3", "referee.time_limit=3"});
  trial.runUntilPlaying();
  EXPECT_EQ(trial.referee().scoreText(), "attempt 1 of 3");
  trial.shoot(1.9, 0.6, 2, 0);
  trial.run(0.5);
  ASSERT_EQ(trial.attempts().size(), 1U);
  EXPECT_EQ(trial.referee().scoreText(), "attempt 1 of 3: goal; 1 passed");
  EXPECT_EQ(trial.attempts()[0].outcome, Outcome::kGoal);
  EXPECT_TRUE(trial.attempts()[0].passed);
  EXPECT_EQ(trial.referee().score(Team::kRed), 1);
  trial.runUntilPlaying();
  EXPECT_EQ(trial.referee().scoreText(), "attempt 2 of 3; 1 passed");
  trial.shoot(1.9, 1.2, 2, 0);
  trial.run(0.5);
  ASSERT_EQ(trial.attempts().size(), 2U);
  EXPECT_EQ(trial.attempts()[1].outcome, Outcome::kBeside);
  trial.runUntilPlaying();
  trial.run(3.01);
  ASSERT_EQ(trial.attempts().size(), 3U);
  EXPECT_EQ(trial.attempts()[2].outcome, Outcome::kTimeUp);
  EXPECT_NEAR(trial.attempts()[2].time, 3, 0.02);
  EXPECT_TRUE(trial.watch->finished());
  EXPECT_EQ(trial.referee().scoreText(), "1 of 3 attempts passed");
}

TEST(PenaltyKick, IsSavedWhenTheKeeperTouchedTheBallLast) {
  Trial trial("penalty_kick", {"referee.attempts=1", "referee.scatter=0", "referee.scatter_heading=0"});
  trial.runUntilPlaying();
  trial.shoot(1.9, 0.0, 0.8, 0);  // into the keeper's feet
  trial.run(4);
  ASSERT_EQ(trial.attempts().size(), 1U);
  EXPECT_EQ(trial.attempts()[0].outcome, Outcome::kSaved);
  EXPECT_EQ(trial.referee().score(Team::kRed), 0);
}

TEST(Trial, EachAttemptBeginsWhereTheScenarioHasEverythingButForTheScatter) {
  Trial trial("penalty_kick", {"referee.attempts=2", "referee.time_limit=0.5", "referee.scatter=0.05"});
  auto base = trial.simulation->linked().handle(trial.robot(), kBasePose);
  auto ball = trial.simulation->linked().handle(trial.robot("ball"), kBasePose);
  std::vector<Vector3> starts;
  for (int attempt = 0; attempt < 2; ++attempt) {
    trial.runUntilPlaying();
    starts.push_back(base.get().translation);
    EXPECT_LT(norm(starts.back() - Vector3{0.35, 0, starts.back().z}), 0.25);
    EXPECT_NEAR(ball.get().translation.x, 0.75, 1e-3);
    trial.shoot(1.0, 1.0, 0, 0);
    trial.run(0.6);
  }
  EXPECT_GT(norm(starts[0] - starts[1]), 1e-3);
}

TEST(Trial, ContinuesFromACheckpoint) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "murosimf_trial_test.checkpoint";
  const std::vector<std::string> settings{"referee.attempts=2", "referee.time_limit=2"};
  Trial whole("penalty_kick", settings);
  whole.run(4);
  saveCheckpoint(file.string(), *whole.simulation, "penalty_kick");
  whole.run(4);
  Trial rest("penalty_kick", settings);
  loadCheckpoint(file.string(), *rest.simulation);
  rest.run(4);
  std::filesystem::remove(file);
  EXPECT_EQ(whole.simulation->stateHash(), rest.simulation->stateHash());
  ASSERT_EQ(whole.attempts().size(), rest.attempts().size());
  EXPECT_EQ(whole.attempts().back().time, rest.attempts().back().time);
}

}  // namespace
}  // namespace murosimf
