// Going back in time: what is run again has the same bits.

#include "murosimf/simulation/frame_history.h"

#include <gtest/gtest.h>

#include "game/game.h"
#include "game/game_observers.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {
namespace {

/// Three against three with falls and contacts: the referee's kick-off, pictures, messages, everything.
struct Game {
  explicit Game(const std::vector<std::string>& overrides = {}) {
    scene = readScenario("scenarios/game_3v3.toml", overrides, diagnostics);
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    observers = std::make_unique<GameObservers>(*scene, *simulation);
  }
  ~Game() { simulation->control()->finish(); }
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<GameObservers> observers;
};

const std::vector<std::string> kMixed = {"robots.red.1.level=fast", "robots.blue.2.level=fast"};

std::vector<std::uint64_t> hashesUntil(FrameHistory& history, Simulation& simulation, long frame) {
  std::vector<std::uint64_t> hashes;
  while (simulation.frame() < frame) {
    history.step();
    hashes.push_back(simulation.stateHash());
  }
  return hashes;
}

TEST(FrameHistory, FramesThatAreRunAgainHaveTheSameBits) {
  Game game(kMixed);
  FrameHistory history(*game.simulation);
  history.goTo(150);
  const std::vector<std::uint64_t> first = hashesUntil(history, *game.simulation, 420);
  history.goTo(150);
  EXPECT_EQ(game.simulation->frame(), 150);
  EXPECT_EQ(hashesUntil(history, *game.simulation, 420), first);
}

TEST(FrameHistory, ThatIsKeptChangesNothing) {
  Game kept(kMixed), plain(kMixed);
  FrameHistory history(*kept.simulation, {0.02});
  history.goTo(300);
  while (plain.simulation->frame() < 300) plain.simulation->step();
  EXPECT_EQ(kept.simulation->stateHash(), plain.simulation->stateHash());
}

TEST(FrameHistory, InterventionsOfPeopleAreRepeatedUntilTheyAskForSomethingElse) {
  Game game;
  FrameHistory history(*game.simulation);
  Intervention place;
  place.kind = Intervention::Kind::kPlaceBody;
  place.object = game.simulation->world().find("ball");
  place.pose = {1, 0.5, 0}, place.height = 0.07;
  history.goTo(250);
  history.request(place);
  history.goTo(400);
  const std::uint64_t placed = game.simulation->stateHash();
  history.goTo(220);
  EXPECT_EQ(history.lastFrame(), 400);
  history.goTo(400);
  EXPECT_EQ(game.simulation->stateHash(), placed);
  history.goTo(240);
  place.pose.x = -1;
  history.request(place);
  EXPECT_EQ(history.lastFrame(), 240);
  history.goTo(400);
  EXPECT_NE(game.simulation->stateHash(), placed);
}

TEST(FrameHistory, KeepsToItsMemoryAndStillReachesEveryFrame) {
  Game game;
  FrameHistory all(*game.simulation);
  const std::size_t one = all.bytes();
  FrameHistory history(*game.simulation, {0.01, 8 * one});
  history.goTo(300);
  EXPECT_LT(history.bytes(), 10 * one);
  const std::uint64_t end = game.simulation->stateHash();
  history.goTo(37);
  EXPECT_EQ(game.simulation->frame(), 37);
  history.goTo(300);
  EXPECT_EQ(game.simulation->stateHash(), end);
}

}  // namespace
}  // namespace murosimf
