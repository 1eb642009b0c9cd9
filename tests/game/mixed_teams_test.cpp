// Robots on wheels play with and against humanoids.

#include <gtest/gtest.h>

#include <cmath>

#include "game/game.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf::test {
namespace {

struct MixedTeams {
  explicit MixedTeams(const std::vector<std::string>& overrides = {}) {
    Diagnostics diagnostics;
    scene = readScenario(MUROSIMF_SOURCE_DIR "/scenarios/mixed_teams.toml", overrides, diagnostics).value();
    simulation = buildGame(scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    client::GameInfo playing;
    playing.phase = client::GamePhase::kPlaying, playing.own_kickoff = true;
    playing.time_left = 600, playing.restart_count = 1;
    for (int i = 0; i < simulation->control()->robotCount(); ++i) simulation->control()->setGame(i, playing);
  }
  ~MixedTeams() { simulation->control()->finish(); }
  MixedTeams(const MixedTeams&) = delete;
  MixedTeams& operator=(const MixedTeams&) = delete;
  void run(double seconds) {
    for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
    simulation->control()->finish();
  }
  Vector3 placeOf(const char* path) const {
    return simulation->linked().handle(simulation->world().find(path), kBasePose).get().translation;
  }

  Scene scene;
  std::unique_ptr<Simulation> simulation;
};

TEST(MixedTeamsScenario, RobotsOnWheelsReachTheBallAndMoveItAtEachLevel) {
  for (const char* level : {"oracle", "fast"}) {
    MixedTeams game({std::string("robots.red.3.level=") + level, std::string("robots.blue.3.level=") + level});
    double nearest_red = 10, nearest_blue = 10, moved = 0;
    for (int i = 0; i < 120; ++i) {
      game.run(0.1);
      const Vector3 ball = game.placeOf("ball");
      nearest_red = std::min(nearest_red, norm(game.placeOf("robots.red.3") - ball));
      nearest_blue = std::min(nearest_blue, norm(game.placeOf("robots.blue.3") - ball));
      moved = std::max(moved, norm(Vector3{ball.x, ball.y, 0}));
    }
    EXPECT_LT(std::min(nearest_red, nearest_blue), 0.3) << level;
    EXPECT_GT(moved, 0.3) << level;
    EXPECT_TRUE(game.simulation->control()->faults().empty());
    EXPECT_LT(std::fabs(game.placeOf("robots.red.3").z), 0.02);
  }
}

TEST(MixedTeamsScenario, AnyNumberOfThreadsGivesTheSameBits) {
  MixedTeams one({"simulation.threads=1"}), two({"simulation.threads=2"});
  one.run(3), two.run(3);
  EXPECT_EQ(one.simulation->stateHash(), two.simulation->stateHash());
}

}  // namespace
}  // namespace murosimf::test
