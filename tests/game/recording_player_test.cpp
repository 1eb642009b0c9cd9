// A recording, shown in a world of the same scenario.

#include "murosimf/simulation/recording_player.h"

#include <gtest/gtest.h>

#include "game/game.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/frame_history.h"
#include "murosimf/simulation/recorder.h"

namespace murosimf {
namespace {

struct Game {
  Game() {
    scene = readScenario("scenarios/game_3v3.toml",
                         {"robots.red.2.level=full", "robots.all.cameras.head=none", "robots.all.cameras.chest=none"},
                         diagnostics);
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
  }
  ~Game() { simulation->control()->finish(); }
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;
  /// X_WB of a hand: a body at the end of a chain.
  Pose hand(const char* robot) {
    const ObjectId id = simulation->world().find(robot);
    const int last = static_cast<int>(simulation->world().members(id, subset::kBodies).size()) - 1;
    return simulation->linked().handle(id, kBodyPose, subset::kBodies).get(last);
  }

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
};

const std::filesystem::path kFile = std::filesystem::temp_directory_path() / "murosimf_player_test.rec";

TEST(RecordingPlayer, ShowsBodiesWhereTheyWere) {
  Game played;
  Recorder recorder(kFile, *played.simulation, "game", 1);
  played.simulation->observe(&recorder);
  for (int i = 0; i < 301; ++i) played.simulation->step();
  const Pose kinematic = played.hand("robots.red.1"), full = played.hand("robots.red.2");
  for (int i = 0; i < 200; ++i) played.simulation->step();
  EXPECT_EQ(recorder.finish(), "");

  Game shown;
  shown.simulation->step();
  FrameHistory history(*shown.simulation);
  const std::uint64_t before = shown.simulation->stateHash();
  RecordingPlayer player(kFile, *shown.simulation);
  EXPECT_NEAR(player.endTime(), 0.501, 1e-9);
  player.show(0.301);
  EXPECT_NEAR(player.time(), 0.301, 1e-9);
  EXPECT_LT(norm(shown.hand("robots.red.1").translation - kinematic.translation), 0.002);
  EXPECT_LT(norm(shown.hand("robots.red.2").translation - full.translation), 0.002);
  history.restore();
  EXPECT_EQ(shown.simulation->stateHash(), before);
  std::filesystem::remove(kFile);
}

TEST(RecordingPlayer, RefusesARecordingOfSomethingElse) {
  Game game;
  EXPECT_THROW(RecordingPlayer("scenarios/game_3v3.toml", *game.simulation), std::runtime_error);
  EXPECT_THROW(RecordingPlayer("nowhere.rec", *game.simulation), std::runtime_error);
}

}  // namespace
}  // namespace murosimf
