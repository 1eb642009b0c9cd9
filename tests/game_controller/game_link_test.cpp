// A game controller's socket, over the loopback.

#include "murosimf/control/game_controller/game_link.h"

#include <gtest/gtest.h>

#include <chrono>

namespace murosimf::game_controller {
namespace {

/// Somebody in the hall: receives what is sent to its port, sends to the game controller.
struct Listener {
  FileDescriptor socket = openUdp("127.0.0.1", 0, false);

  GameLinkSettings settings() const {
    GameLinkSettings s;
    s.port = portOf(socket);
    s.return_port = 0;
    return s;
  }
  Bytes next() const {
    Bytes bytes;
    UdpAddress from;
    for (int i = 0; i < 5000 && !receiveUdp(socket, bytes, from, 2000); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return bytes;
  }
  void say(const GameLink& link, const Bytes& bytes) const {
    EXPECT_TRUE(sendUdp(socket, udpAddress("127.0.0.1", link.returnPort()), bytes));
  }
};

/// Until something holds.
template <class Condition>
bool waitFor(const Condition& condition) {
  for (int i = 0; i < 5000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

TEST(GameLink, PacketsArriveAsTheyWereSentAndInTheirOrder) {
  const Listener hall;
  GameLink link(hall.settings());
  for (int packet = 0; packet < 20; ++packet) {
    GameState game;
    game.packet = packet;
    link.send(encodeControl(game, Format::kHsl19));
  }
  for (int packet = 0; packet < 20; ++packet) {
    const Bytes bytes = hall.next();
    ASSERT_EQ(bytes.size(), 198U);
    EXPECT_EQ(bytes[5], packet);
  }
  EXPECT_TRUE(waitFor([&] { return link.counts().sent == 20; }));
}

TEST(GameLink, RobotsAreHeardInBothFormats) {
  const Listener hall;
  const GameLink link(hall.settings());
  hall.say(link, encodeStatus({3, 12, false, 1.5F}));
  hall.say(link, encodeStatus({3, 12, true, 2.5F}));
  hall.say(link, encodeMessage({4, 33, RobotMessage::Kind::kAlive}));
  ASSERT_TRUE(waitFor([&] { return link.counts().heard == 3; }));
  const auto robots = link.robots();
  ASSERT_EQ(robots.size(), 2U);
  EXPECT_EQ(robots.at({12, 3}).packets, 2);
  EXPECT_TRUE(robots.at({12, 3}).status.fallen) << "the last word counts";
  EXPECT_FLOAT_EQ(robots.at({12, 3}).status.x, 2.5F);
  EXPECT_EQ(robots.at({33, 4}).packets, 1);
}

TEST(GameLink, PacketsThatAreWrongAreCountedAndTold) {
  const Listener hall;
  const GameLink link(hall.settings());
  hall.say(link, {'R', 'G', 'r', 't', 9});
  ASSERT_TRUE(waitFor([&] { return link.counts().refused == 1; }));
  EXPECT_EQ(link.counts().last_problem, "RGrt of version 9 in 5 bytes, expected version 4 in 32");
  hall.say(link, Bytes(1400, 0xFF));
  ASSERT_TRUE(waitFor([&] { return link.counts().refused == 2; }));
  EXPECT_TRUE(link.robots().empty());
}

TEST(GameLink, StrangersAreNotHeard) {
  const Listener hall;
  GameLinkSettings settings = hall.settings();
  settings.allowed = {"192.0.2.1"};
  const GameLink link(settings);
  hall.say(link, encodeStatus({3, 12}));
  ASSERT_TRUE(waitFor([&] { return link.counts().strangers == 1; }));
  EXPECT_TRUE(link.robots().empty());
}

TEST(GameLink, AFloodOfRobotsThatDoNotExistFillsNoMemory) {
  const Listener hall;
  const GameLink link(hall.settings());
  long said = 0;
  for (int team = 0; team < 20; ++team) {
    for (int player = 1; player <= 20; ++player) {
      hall.say(link, encodeStatus({player, team}));
      ++said;
      ASSERT_TRUE(waitFor([&] { return link.counts().heard + link.counts().refused == said; }));
    }
  }
  EXPECT_EQ(link.robots().size(), 64U);
}

TEST(GameLink, PortInUseIsTold) {
  const Listener hall;
  GameLinkSettings settings = hall.settings();
  settings.return_port = portOf(hall.socket);
  try {
    const GameLink link(settings);
    FAIL() << "two hear on one port";
  } catch (const std::system_error& problem) {
    EXPECT_NE(std::string(problem.what()).find("Address already in use"), std::string::npos) << problem.what();
  }
}

}  // namespace
}  // namespace murosimf::game_controller
