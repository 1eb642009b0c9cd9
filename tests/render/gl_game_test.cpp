// Games in which OpenGL makes pictures for the robots' control software.

#include <gtest/gtest.h>

#include <cmath>

#include "game/game.h"
#include "game/game_observers.h"
#include "game/picture_drawers.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/frame_history.h"

namespace murosimf {
namespace {

using Words = std::vector<std::string>;

/// The 3 versus 3 game with its reference player.
struct Game {
  explicit Game(const Words& overrides) {
    scene = readScenario("scenarios/game_3v3.toml", overrides, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    simulation = buildGame(*scene, diagnostics);
    if (simulation != nullptr) observers = std::make_unique<GameObservers>(*scene, *simulation);
  }
  ~Game() {
    if (simulation != nullptr) simulation->control()->finish();
  }
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;

  void playTo(long frame) const {
    while (simulation->frame() < frame) simulation->step();
    simulation->control()->finish();
  }
  const RobotCamera& camera(int robot, std::size_t number) const {
    return *simulation->control()->robot(robot).cameras.at(number);
  }
  const RobotCamera& head(int robot) const { return camera(robot, 1); }

  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<GameObservers> observers;
};

const Words kAll = {"robots.all.cameras.head.module=opengl", "robots.all.cameras.chest.module=opengl"};
const Words kOne = {"robots.red.1.cameras.head.module=opengl", "robots.all.cameras.chest=none"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

double equalLabels(const Picture& a, const Picture& b) {
  double equal = 0;
  for (std::size_t i = 0; i < a.label.size(); ++i) equal += a.label[i] == b.label[i] ? 1 : 0;
  return equal / static_cast<double>(a.label.size());
}
double meanDifference(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum / static_cast<double>(a.rgb.size());
}

/// Until the first pictures have arrived, both games are the same.
TEST(GlGame, RobotsSeeWhatTheRayCasterShows) {
  const Words lens = {"robots.red.2.cameras.head.lens=robots/lenses/fisheye_165.yaml"};
  const Game cast(lens), drawn(with(kAll, lens));
  cast.playTo(100), drawn.playTo(100);
  int compared = 0;
  for (int robot = 0; robot < cast.simulation->control()->robotCount(); ++robot) {
    for (std::size_t i = 0; i < cast.simulation->control()->robot(robot).cameras.size(); ++i) {
      const Picture &truth = cast.camera(robot, i).picture(), &seen = drawn.camera(robot, i).picture();
      ASSERT_EQ(truth.label.size(), seen.label.size());
      ASSERT_FALSE(seen.label.empty());
      EXPECT_EQ(cast.camera(robot, i).time(), drawn.camera(robot, i).time());
      EXPECT_GT(equalLabels(truth, seen), 0.999) << robot << " " << i;
      EXPECT_LT(meanDifference(truth, seen), 1.0) << "noise is the same, of bytes that are rounded before";
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12);
  EXPECT_NE(drawerText(*drawn.simulation).find("pictures of 12 cameras by OpenGL"), std::string::npos);
  EXPECT_EQ(drawerText(*cast.simulation), "");
}

std::uint64_t hashAfter(const Words& overrides, long frames) {
  const Game game(overrides);
  game.playTo(frames);
  EXPECT_TRUE(game.simulation->control()->faults().empty());
  EXPECT_GT(game.simulation->control()->counts().pictures, 30);
  return game.simulation->stateHash();
}

TEST(GlGame, IsTheSameForAnyNumberOfThreads) {
  const Words mixed =
      with(kOne, {"robots.blue.2.cameras.head.module=opengl", "robots.blue.2.cameras.head.period=0.09"});
  const std::uint64_t first = hashAfter(with(mixed, {"simulation.threads=1"}), 700);
  EXPECT_EQ(hashAfter(with(mixed, {"simulation.threads=3"}), 700), first);
}

TEST(GlGame, GoesBackWithPicturesOnTheirWay) {
  const Game game(
      with(kOne, {"robots.red.1.cameras.head.chain=[\"exposure\", \"noise\", \"latency\"]",
                  "robots.red.1.cameras.head.exposure_target=0.4", "robots.red.1.cameras.head.latency_delay=0.12"}));
  FrameHistory history(*game.simulation);
  history.goTo(600);
  const std::uint64_t first = game.simulation->stateHash();
  game.simulation->control()->finish();
  const Picture seen = game.head(0).picture();
  history.goTo(235);
  history.goTo(600);
  game.simulation->control()->finish();
  EXPECT_EQ(game.simulation->stateHash(), first);
  EXPECT_EQ(game.head(0).picture().rgb, seen.rgb);
}

TEST(GlGame, MorePicturesThanAnAtlasHoldsAreDrawnInSeveral) {
  const Words large = {"robots.all.cameras.head.lens=" MUROSIMF_SOURCE_DIR "/tests/data/tall_lens.yaml"};
  const Game game(with(with(kAll, large), {"robots.all.cameras.chest=none"}));
  const Game cast(with(large, {"robots.all.cameras.chest=none"}));
  game.playTo(60), cast.playTo(60);
  for (int robot = 0; robot < 6; ++robot)
    EXPECT_GT(equalLabels(cast.head(robot).picture(), game.head(robot).picture()), 0.999) << robot;
}

TEST(GlGame, TellsWhatOpenGlCannotDo) {
  const auto said = [](const std::string& more) {
    Game game(with(kOne, {more}));
    return game.diagnostics.text();
  };
  EXPECT_NE(said("robots.red.1.cameras.head.shadows=true").find("camera module opengl has no shadows"),
            std::string::npos);
  EXPECT_NE(said("field.texture=docs/images/game.png").find("camera module opengl draws no picture on the carpet"),
            std::string::npos);
}

}  // namespace
}  // namespace murosimf
