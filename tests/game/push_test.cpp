// People push bodies through the queue of interventions.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "game/game.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/checkpoint.h"
#include "murosimf/simulation/recorder.h"
#include "murosimf/simulation/recording_reader.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {
namespace {

/// Robots that nobody controls: they stand.
struct Stand {
  explicit Stand(std::vector<std::string> overrides = {}) {
    overrides.insert(overrides.end(),
                     {"robots.all.control=none", "robots.all.cameras.head=none", "robots.all.cameras.chest=none"});
    scene = readScenario("scenarios/game_3v3.toml", overrides, diagnostics);
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    for (int i = 0; i < 100; ++i) simulation->step();
  }
  ObjectId object(const char* path) const { return simulation->world().find(path); }
  Vector3 place(const char* path) { return simulation->linked().handle(object(path), kBasePose).get().translation; }
  void push(const char* path, int row, const Vector3& force_W, int frames) {
    for (int i = 0; i < frames; ++i) {
      simulation->interventions().push(simulation->frame(), object(path), row, place(path), force_W);
      simulation->step();
    }
  }

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
};

TEST(Push, GivesAFreeBodyForceTimesTimeOverMass) {
  Stand game;
  auto velocity = game.simulation->linked().handle(game.object("ball"), kBodyVelocity);
  game.simulation->interventions().placeBody(game.simulation->frame(), game.object("ball"), {0, 1, 1});
  game.simulation->step();
  const Vector3 before = velocity.get();
  game.push("ball", 0, {2, -1, 0}, 10);
  EXPECT_NEAR(velocity.get().x - before.x, 2 * 0.010 / 0.205, 1e-9);
  EXPECT_NEAR(velocity.get().y - before.y, -1 * 0.010 / 0.205, 1e-9);
}

TEST(Push, MovesARobotThatRecoilsAndNotOneWhoseMotionIsPrescribed) {
  for (const char* level : {"full", "fast", "kinematic"}) {
    Stand game({std::string("robots.red.2.level=") + level});
    const Vector3 before = game.place("robots.red.2");
    game.push("robots.red.2", 0, {0, 25, 0}, 250);
    const double moved = game.place("robots.red.2").y - before.y;
    if (std::string(level) == "kinematic") {
      EXPECT_NEAR(moved, 0, 1e-6) << level;
    } else {
      EXPECT_GT(moved, 0.02) << level;
    }
  }
}

TEST(Push, EndsWithItsFrame) {
  Stand game({"robots.red.2.level=full"});
  auto force = game.simulation->linked().handle(game.object("robots.red.2"), kPairForce, subset::kBodies);
  game.push("robots.red.2", 3, {0, 0, 5}, 1);
  EXPECT_NEAR(norm(force.get(3).f), 5, 1e-9);
  game.simulation->step();
  EXPECT_EQ(norm(force.get(3).f), 0);
}

TEST(Push, OfABodyThatIsNotThereIsRefused) {
  Stand game;
  InterventionQueue& queue = game.simulation->interventions();
  EXPECT_THROW(queue.push(0, game.object("ball"), 1, {}, {}), std::invalid_argument);
  EXPECT_THROW(queue.push(0, game.object("robots.red.1"), 99, {}, {}), std::invalid_argument);
  EXPECT_THROW(queue.push(0, game.simulation->world().root(), 0, {}, {}), std::invalid_argument);
  EXPECT_THROW(queue.push(0, game.object("ball"), 0, {}, Vector3{0, 0, HUGE_VAL}), std::invalid_argument);
}

TEST(Push, AndExchangesOfLevelsStandInRecordings) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "murosimf_push_test.rec";
  {
    Stand game({"robots.red.3.motion=\"kinematic_walking, multibody_dynamics@1000\""});
    Recorder recorder(file, *game.simulation, "game", 1);
    game.simulation->observe(&recorder);
    game.push("ball", 0, {1, 2, 3}, 1);
    game.simulation->interventions().exchangeLevel(game.simulation->frame(), game.object("robots.red.3"), 1);
    for (int i = 0; i < 20; ++i) game.simulation->step();
    EXPECT_EQ(recorder.finish(), "");
  }
  RecordingReader reader(file);
  std::vector<RecordedIntervention> all;
  while (reader.next()) all.insert(all.end(), reader.interventions().begin(), reader.interventions().end());
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].kind, Intervention::Kind::kPush);
  EXPECT_EQ(all[0].velocity, (Vector3{1, 2, 3}));
  EXPECT_EQ(all[1].kind, Intervention::Kind::kExchangeLevel);
  EXPECT_EQ(all[1].level, 1);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace murosimf
