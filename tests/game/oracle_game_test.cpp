// Games in which cameras and localisation tell the truth instead of pictures: what is told of the field, and play.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "game/game.h"
#include "game/game_observers.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {
namespace {

struct OracleGame {
  explicit OracleGame(std::vector<std::string> more = {}) {
    more.insert(more.begin(), "robots.all.level=oracle");
    scene = readScenario("scenarios/game_3v3.toml", more, diagnostics);
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    referee = std::make_unique<GameObservers>(*scene, *simulation);
  }
  ~OracleGame() { simulation->control()->finish(); }
  OracleGame(const OracleGame&) = delete;
  OracleGame& operator=(const OracleGame&) = delete;

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<GameObservers> referee;
};

/// Checks every sight of a robot against the field.
class FieldWitness final : public ControlObserver {
 public:
  explicit FieldWitness(const Simulation& simulation) : view_(simulation.view()) {}
  void onSensors(int, long) override {}
  void onStep(int robot, long frame, const client::SensorFrame& sensors, const ControlledRobot& controlled,
              const client::ControlReport&) override {
    if (robot != 0) return;
    for (const client::CameraSights& sights : sensors.sights) {
      // The keeper has only just started to move: its camera is where it was.
      if (std::fabs(sights.time - sensors.time) > 1e-9) continue;
      const Pose X_WC = controlled.camera(static_cast<std::size_t>(sights.camera))->place(view_, frame).X_WC;
      for (const client::SeenThing& thing : sights.things) check(sights.kind, thing, X_WC);
    }
  }
  std::set<std::string> posts, poles;
  int lines = 0;

 private:
  void check(client::ThingKind kind, const client::SeenThing& thing, const Pose& X_WC) {
    const Vector3 p = X_WC * thing.p_C, q = X_WC * thing.q_C;
    if (kind == client::ThingKind::kPost) {
      EXPECT_NEAR(std::fabs(p.x), 2.25, 1e-9);
      EXPECT_EQ(thing.mark, p.x > 0 ? "yellow" : "blue");
      posts.insert(std::string(thing.mark) + (p.y > 0 ? " left" : " right"));
    } else if (kind == client::ThingKind::kPole) {
      EXPECT_LT(norm(p - Vector3{0, thing.mark == "yellow" ? 1.5 : -1.5, 0}), 1e-9);
      poles.insert(std::string(thing.mark));
    } else if (kind == client::ThingKind::kLine) {
      EXPECT_LE(std::max(std::fabs(p.x), std::fabs(q.x)), 2.25 + 1e-9);
      EXPECT_LE(std::max(std::fabs(p.y), std::fabs(q.y)), 1.5 + 1e-9);
      EXPECT_NEAR(p.z, 0, 1e-9);
      ++lines;
    }
  }
  const SceneView& view_;
};

TEST(OracleGame, PostsPolesAndLinesAreWhereTheFieldHasThem) {
  OracleGame game({"robots.all.control=none", "robots.red.1.control=player", "robots.red.1.pose=[-1.5, 0, 0]",
                   "simulation.threads=1"});
  FieldWitness witness(*game.simulation);
  game.simulation->control()->observe(&witness);
  for (int i = 0; i < 3000; ++i) {
    game.simulation->step();
    game.simulation->control()->finish();  // the task of this frame looks at the world as it is
  }
  EXPECT_EQ(witness.posts.count("yellow left"), 1U);
  EXPECT_EQ(witness.posts.count("yellow right"), 1U);
  EXPECT_EQ(witness.poles.size(), 2U);
  EXPECT_GT(witness.lines, 100);
}

TEST(OracleGame, ThePlayerFindsTheBallAndKicksIt) {
  OracleGame game({"robots.all.control=none", "robots.red.3.control=player"});
  const Handle<Pose> ball = game.simulation->linked().handle(game.simulation->world().find("ball"), kBasePose);
  for (int i = 0; i < 20000; ++i) game.simulation->step();
  game.simulation->control()->finish();
  const client::ControlReport& report = *game.simulation->control()->report(2);
  EXPECT_TRUE(report.pose_valid);
  EXPECT_GE(report.kicks_started, 1U);
  EXPECT_GT(ball.get().translation.x, 0.3) << "towards the goal that red attacks";
}

TEST(OracleGame, ThePlayerLivesWithWrongPercepts) {
  OracleGame game({"robots.all.control=none", "robots.red.3.control=player", "robots.all.localisation=none",
                   "robots.all.cameras.head.bearing_noise=0.02", "robots.all.cameras.head.distance_noise=0.05",
                   "robots.all.cameras.head.miss=0.2", "robots.all.cameras.head.false_rate=0.5",
                   "robots.all.cameras.head.outage_rate=0.05"});
  const Handle<Pose> ball = game.simulation->linked().handle(game.simulation->world().find("ball"), kBasePose);
  for (int i = 0; i < 30000; ++i) game.simulation->step();
  game.simulation->control()->finish();
  EXPECT_GE(game.simulation->control()->report(2)->kicks_started, 1U);
  EXPECT_GT(norm(ball.get().translation - Vector3{0, 0, ball.get().translation.z}), 0.3);
}

}  // namespace
}  // namespace murosimf
