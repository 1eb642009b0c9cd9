// The referee as a game controller: what it sends of a game, byte by byte, and what it hears.

#include "game/game_broadcast.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>

#include "game/game.h"
#include "game/game_observers.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/state_hash.h"

namespace murosimf {
namespace {

using game_controller::Bytes;

/// A robot's software in the hall: hears what the game controller sends, and tells of itself.
struct Hall {
  FileDescriptor socket = openUdp("127.0.0.1", 0, false);

  std::vector<Bytes> packets() const {
    std::vector<Bytes> all;
    Bytes bytes;
    UdpAddress from;
    for (int silent = 0; silent < 50; ++silent) {
      while (receiveUdp(socket, bytes, from, 2000)) all.push_back(bytes), silent = 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return all;
  }
};

struct BroadcastGame {
  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<GameObservers> observers;

  BroadcastGame(const Hall& hall, const std::string& format) {
    scene =
        readScenario("scenarios/game_3v3.toml",
                     {"robots.all.level=oracle", "game_controller.role=send", "game_controller.format=" + format,
                      "game_controller.port=" + std::to_string(portOf(hall.socket)), "game_controller.return_port=0",
                      "game_controller.red_number=12", "game_controller.blue_number=33", "referee.half_length=60"},
                     diagnostics);
    simulation = buildGame(*scene, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    observers = std::make_unique<GameObservers>(*scene, *simulation);
  }
  ~BroadcastGame() { simulation->control()->finish(); }
  BroadcastGame(const BroadcastGame&) = delete;
  BroadcastGame& operator=(const BroadcastGame&) = delete;
  void play(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) simulation->step();
  }
};

/// Where a format has what is looked at here [header files named in packets.h].
struct Layout {
  const char* format;
  std::size_t size, version, packet, state, kicking, seconds, red, blue, score;
  int number;
};
constexpr Layout kLayouts[] = {{"hsl19", 198, 4, 5, 10, 13, 14, 18, 108, 4, 19},
                               {"spl18", 118, 4, 5, 10, 13, 14, 18, 68, 4, 18},
                               {"hl15", 118, 4, 5, 10, 13, 14, 18, 68, 4, 15},
                               {"hl12", 688, 4, 6, 9, 11, 20, 24, 356, 2, 12}};

int wordAt(const Bytes& bytes, std::size_t at) { return bytes[at] + 256 * bytes[at + 1]; }

class BroadcastFormats : public ::testing::TestWithParam<Layout> {};

TEST_P(BroadcastFormats, TellTheGameFromTheKickOffOn) {
  const Layout& layout = GetParam();
  const Hall hall;
  BroadcastGame game(hall, layout.format);
  game.play(3);
  const std::vector<Bytes> packets = hall.packets();
  // 1 s of kSet every 0.2 s from the first frame on, then the whistle and play every 0.5 s.
  ASSERT_EQ(packets.size(), 5U + 5U) << layout.format;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    const Bytes& p = packets[i];
    ASSERT_EQ(p.size(), layout.size);
    EXPECT_EQ(std::string(p.begin(), p.begin() + 4), "RGme");
    EXPECT_EQ(p[layout.version], layout.number);
    EXPECT_EQ(p[layout.packet], i) << "packets are counted";
    EXPECT_EQ(p[layout.state], i < 5 ? 2 : 3) << "set, then playing";
    EXPECT_EQ(p[layout.red], 12);
    EXPECT_EQ(p[layout.blue], 33);
    EXPECT_EQ(p[layout.red + layout.score], 0);
    EXPECT_EQ(p[layout.blue + layout.score], 0);
  }
  EXPECT_EQ(packets.front()[layout.kicking], 12) << "red has the kick-off";
  EXPECT_EQ(wordAt(packets.front(), layout.seconds), 60);
  EXPECT_EQ(wordAt(packets.back(), layout.seconds), 57) << "sent when 57 s and no more are left";
}

INSTANTIATE_TEST_SUITE_P(All, BroadcastFormats, ::testing::ValuesIn(kLayouts),
                         [](const auto& layout) { return std::string(layout.param.format); });

TEST(GameBroadcast, GoalIsToldWithItsScoreAndThePause) {
  const Hall hall;
  BroadcastGame game(hall, "hsl19");
  game.play(1.5);
  const ObjectId ball = game.simulation->world().find("ball");
  game.simulation->interventions().placeBody(game.simulation->frame(), ball, {2.2, 0, 0.07}, {3, 0, 0});
  game.play(0.5);
  const std::vector<Bytes> packets = hall.packets();
  ASSERT_FALSE(packets.empty());
  const Bytes& last = packets.back();
  EXPECT_EQ(last[22], 1) << "red's score";
  EXPECT_EQ(last[112], 0);
  EXPECT_EQ(last[10], 1) << "ready";
  EXPECT_EQ(last[8], 1) << "stopped";
  EXPECT_EQ(last[13], 33) << "blue has the kick-off";
}

TEST(GameBroadcast, HearsWhatRobotsSayOfThemselves) {
  const Hall hall;
  const BroadcastGame game(hall, "hsl19");
  const game_controller::GameLink& link = game.observers->broadcast()->link();
  Bytes status(32, 0);
  std::copy_n("RGrt", 4, status.begin());
  status[4] = 4, status[5] = 2, status[6] = 12, status[7] = 1;
  EXPECT_TRUE(sendUdp(hall.socket, udpAddress("127.0.0.1", link.returnPort()), status));
  for (int i = 0; i < 5000 && link.counts().heard == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto robots = link.robots();
  ASSERT_EQ(robots.size(), 1U);
  EXPECT_EQ(robots.begin()->first, std::make_pair(12, 2));
  EXPECT_TRUE(robots.begin()->second.status.fallen);
}

/// Nobody who sends anything to its ports changes a bit of the game.
TEST(GameBroadcast, WhatIsSentToItChangesNoBit) {
  const auto hashOf = [](bool attacked) {
    const Hall hall;
    BroadcastGame game(hall, "hsl19");
    const int port = game.observers->broadcast()->link().returnPort();
    std::atomic<bool> ends{false};
    std::thread attacker([&] {
      std::uint32_t random = 1;
      while (attacked && !ends) {
        Bytes noise(random % 300);
        for (std::uint8_t& byte : noise)
          random = random * 1664525U + 1013904223U, byte = static_cast<std::uint8_t>(random >> 24);
        if (random % 3 == 0 && noise.size() > 5) std::copy_n("RGrt\x04", 5, noise.begin());
        random = random * 1664525U + 1013904223U;
        sendUdp(hall.socket, udpAddress("127.0.0.1", port), noise);
      }
    });
    game.play(2);
    ends = true;
    attacker.join();
    const auto counts = game.observers->broadcast()->link().counts();
    EXPECT_EQ(counts.refused + counts.heard > 0, attacked);
    return hashState(game.simulation->linked());
  };
  EXPECT_EQ(hashOf(true), hashOf(false));
}

TEST(GameBroadcast, PortThatIsTakenIsToldBeforeTheGame) {
  const Hall hall;
  Diagnostics diagnostics;
  const std::string port = std::to_string(portOf(hall.socket));
  const auto scene = readScenario(
      "scenarios/game_3v3.toml",
      {"robots.all.level=oracle", "game_controller.role=send", "game_controller.return_port=" + port}, diagnostics);
  const auto simulation = buildGame(*scene, diagnostics);
  try {
    const GameObservers observers(*scene, *simulation);
    ADD_FAILURE() << "two listen on one port";
  } catch (const client::CannotStart& problem) {
    EXPECT_EQ(std::string(problem.what()),
              "game_controller: cannot receive on 127.0.0.1:" + port + ": Address already in use");
  }
}

}  // namespace
}  // namespace murosimf
