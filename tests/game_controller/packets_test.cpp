// Packets of game controllers and robots, byte by byte: each test writes offsets and numbers out from the description.

#include "murosimf/control/game_controller/packets.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace murosimf::game_controller {
namespace {

/// A game in which no two numbers are equal where a format tells them apart.
GameState someGame() {
  GameState g;
  g.packet = 200, g.players_per_team = 7, g.competition = 2;
  g.state = State::kPlaying, g.set_play = SetPlay::kCornerKick;
  g.first_half = false, g.kicking_team = 33;
  g.seconds_remaining = 300, g.secondary_seconds = 17;
  g.teams[0].number = 12, g.teams[1].number = 33;
  g.teams[0].field_colour = 1, g.teams[0].keeper_colour = 3, g.teams[1].field_colour = 0;
  g.teams[0].goalkeeper = 4, g.teams[1].goalkeeper = 5;
  g.teams[0].score = 6, g.teams[1].score = 8;
  g.teams[0].penalty_shots = 9, g.teams[0].shots_scored = 0x1234;
  g.teams[1].message_budget = 0x2EE0;  // 12000
  g.teams[1].players[2] = {Penalty::kPushing, 30, 1, 2, 0};
  return g;
}

int two(const Bytes& bytes, std::size_t at) { return bytes[at] | bytes[at + 1] << 8; }

TEST(Hsl19, BytesStandWhereTheDescriptionHasThem) {
  GameState g = someGame();
  g.stopped = true, g.phase = Phase::kExtraTime;
  const Bytes b = encodeControl(g, Format::kHsl19);
  ASSERT_EQ(b.size(), 198U);
  EXPECT_EQ(std::string(b.begin(), b.begin() + 4), "RGme");
  EXPECT_EQ(b[4], 19);
  EXPECT_EQ(b[5], 200) << "packet";
  EXPECT_EQ(b[6], 7) << "players per team";
  EXPECT_EQ(b[7], 2) << "large";
  EXPECT_EQ(b[8], 1) << "stopped";
  EXPECT_EQ(b[9], 2) << "extra time";
  EXPECT_EQ(b[10], 3) << "playing";
  EXPECT_EQ(b[11], 6) << "corner kick";
  EXPECT_EQ(b[12], 0) << "second half";
  EXPECT_EQ(b[13], 33) << "kicking team";
  EXPECT_EQ(two(b, 14), 300);
  EXPECT_EQ(two(b, 16), 17);
  EXPECT_EQ(Bytes(b.begin() + 18, b.begin() + 28), (Bytes{12, 1, 3, 4, 6, 9, 0x34, 0x12, 0, 0}));
  const std::size_t team = 18 + 90;
  EXPECT_EQ(Bytes(b.begin() + team, b.begin() + team + 10), (Bytes{33, 0, 0, 5, 8, 0, 0, 0, 0xE0, 0x2E}));
  const std::size_t player = team + 10 + 2 * 4;
  EXPECT_EQ(Bytes(b.begin() + player, b.begin() + player + 4), (Bytes{9, 30, 1, 2})) << "pushing, 30 s, cards";
}

TEST(Spl18, BytesStandWhereTheDescriptionHasThem) {
  GameState g = someGame();
  g.round = 1, g.competition = 0, g.phase = Phase::kPenaltyShootout;
  for (const auto& [format, version] : {std::pair{Format::kSpl18, 18}, {Format::kHl15, 15}}) {
    const Bytes b = encodeControl(g, format);
    ASSERT_EQ(b.size(), 118U);
    EXPECT_EQ(b[4], version);
    EXPECT_EQ(b[7], 1) << "play-off";
    EXPECT_EQ(b[8], 0) << "competition type";
    EXPECT_EQ(b[9], 1) << "penalty shoot-out";
    EXPECT_EQ(b[10], 3);
    EXPECT_EQ(b[11], 3) << "corner kick";
    EXPECT_EQ(b[13], 33);
    EXPECT_EQ(two(b, 14), 300);
    const std::size_t player = 18 + 50 + 10 + 2 * 2;
    EXPECT_EQ(b[player], 2) << "pushing";
    EXPECT_EQ(b[player + 1], 30);
  }
}

TEST(Hl12, BytesStandWhereTheDescriptionHasThem) {
  const Bytes b = encodeControl(someGame(), Format::kHl12);
  ASSERT_EQ(b.size(), 688U);
  EXPECT_EQ(two(b, 4), 12);
  EXPECT_EQ(Bytes(b.begin() + 6, b.begin() + 18), (Bytes{200, 7, 2, 3, 0, 33, 7, 33, 0, 0, 0, 0}))
      << "packet, players, type, state, half, kick-off, secondary state, its info, drop-in team";
  EXPECT_EQ(two(b, 18), 0xFFFF) << "no drop-in yet";
  EXPECT_EQ(two(b, 20), 300);
  EXPECT_EQ(two(b, 22), 17);
  EXPECT_EQ(Bytes(b.begin() + 24, b.begin() + 30), (Bytes{12, 1, 6, 9, 0x34, 0x12}));
  const std::size_t players = 24 + 332 + 4 + 2 + 1 + 253 + 6;
  EXPECT_EQ(Bytes(b.begin() + players + 12, b.begin() + players + 18), (Bytes{31, 30, 1, 2, 0, 0}))
      << "physical contact";
  EXPECT_EQ(b[players + 4 * 6 + 5], 1) << "player 5 keeps the goal";
  EXPECT_EQ(players + 11 * 6, b.size());
}

TEST(Hl12, PhasesStandInTheSecondaryStateWhereThereIsNoSetPlay) {
  GameState g = someGame();
  g.set_play = SetPlay::kNone, g.phase = Phase::kTimeout;
  const Bytes b = encodeControl(g, Format::kHl12);
  EXPECT_EQ(b[12], 3);
  EXPECT_EQ(b[13], 0);
}

TEST(Control, NobodyKicksIs255) {
  GameState g = someGame();
  g.kicking_team = kNobody;
  EXPECT_EQ(encodeControl(g, Format::kHsl19)[13], 255);
  EXPECT_EQ(encodeControl(g, Format::kHl12)[11], 255);
}

TEST(Control, SecondsBelowZeroAreToldWhereTheFormatCan) {
  GameState g = someGame();
  g.seconds_remaining = -5;
  EXPECT_EQ(two(encodeControl(g, Format::kHsl19), 14), 0xFFFB);
  EXPECT_EQ(two(encodeControl(g, Format::kHl12), 20), 0);
}

GameState arbitraryGame() {
  const auto upTo = [](int last) { return *rc::gen::inRange(0, last + 1); };
  GameState g;
  g.packet = upTo(255), g.players_per_team = upTo(20), g.competition = upTo(2), g.stopped = upTo(1) == 1;
  g.phase = static_cast<Phase>(upTo(3)), g.state = static_cast<State>(upTo(4));
  g.set_play = static_cast<SetPlay>(upTo(6));
  g.first_half = upTo(1) == 1;
  g.kicking_team = upTo(1) == 0 ? kNobody : upTo(254);
  g.seconds_remaining = *rc::gen::inRange(-30000, 30000), g.secondary_seconds = *rc::gen::inRange(-30000, 30000);
  for (TeamState& team : g.teams) {
    team.number = upTo(254), team.field_colour = upTo(9), team.keeper_colour = upTo(9), team.goalkeeper = upTo(20);
    team.score = upTo(255), team.penalty_shots = upTo(255), team.message_budget = upTo(65535);
    team.shots_scored = static_cast<std::uint16_t>(upTo(65535));
    for (PlayerState& p : team.players)
      p = {static_cast<Penalty>(upTo(static_cast<int>(Penalty::kSubstitute))), upTo(255), upTo(255), upTo(255), 0};
  }
  return g;
}

TEST(Hsl19, WhatIsWrittenIsReadAgain) {
  EXPECT_TRUE(rc::check("reading is the inverse of writing", [] {
    const GameState game = arbitraryGame();
    std::string problem;
    const auto decoded = decodeControl(encodeControl(game, Format::kHsl19), problem);
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(decoded->format == Format::kHsl19);
    RC_ASSERT(decoded->game == game);
  }));
}

TEST(Control, WhatHasBeenReadIsWrittenAsItWas) {
  EXPECT_TRUE(rc::check("a packet that went through once goes through unchanged", [] {
    const GameState game = arbitraryGame();
    for (const Format format : {Format::kSpl18, Format::kHl15, Format::kHl12}) {
      std::string problem;
      const Bytes first = encodeControl(game, format);
      const auto decoded = decodeControl(first, problem);
      RC_ASSERT(decoded.has_value());
      RC_ASSERT(decoded->format == format);
      RC_ASSERT(encodeControl(decoded->game, format) == first);
    }
  }));
}

TEST(Control, PenaltiesThatAFormatLacksAreItsGeneralOne) {
  GameState g;
  g.teams[0].players[0].penalty = Penalty::kSentOff;
  EXPECT_EQ(encodeControl(g, Format::kHsl19)[28], 10);
  EXPECT_EQ(encodeControl(g, Format::kSpl18)[28], 15) << "manual";
  g.teams[0].players[0].penalty = Penalty::kService;
  EXPECT_EQ(encodeControl(g, Format::kHsl19)[28], 5) << "pick-up";
}

std::string refusal(Bytes bytes) {
  std::string problem;
  EXPECT_FALSE(decodeControl(bytes, problem));
  return problem;
}

TEST(Control, WhatIsWrongIsTold) {
  EXPECT_EQ(refusal({}), "0 bytes that do not begin with RGme");
  EXPECT_EQ(refusal(Bytes(198)), "198 bytes that do not begin with RGme");
  Bytes good = encodeControl(someGame(), Format::kHsl19);
  Bytes bytes = good;
  bytes.pop_back();
  EXPECT_EQ(refusal(bytes), "version 19 (Humanoid Soccer League) in 197 bytes, expected 198");
  bytes = good, bytes[4] = 77;
  EXPECT_EQ(refusal(bytes), "version 77, expected 12, 15, 18 or 19");
  bytes = good, bytes[9] = 4;
  EXPECT_EQ(refusal(bytes), "the game's phase is 4, expected 0 to 3");
  bytes = good, bytes[10] = 5;
  EXPECT_EQ(refusal(bytes), "the state is 5, expected 0 to 4");
  bytes = good, bytes[11] = 7;
  EXPECT_EQ(refusal(bytes), "the set play is 7, which the format does not have");
  bytes = good, bytes[28] = 99;
  EXPECT_EQ(refusal(bytes), "a player's penalty is 99, which the format does not have");
}

TEST(Control, AnyBytesAreReadWithoutHarm) {
  EXPECT_TRUE(rc::check("random bytes", [](std::vector<std::uint8_t> bytes) {
    std::string problem;
    static_cast<void>(decodeControl(bytes, problem));
    for (const std::size_t size : {118U, 198U, 688U}) {
      bytes.resize(size);
      std::copy_n("RGme", 4, bytes.begin());
      bytes[4] = size == 118 ? 18 : size == 198 ? 19 : 12;
      const auto decoded = decodeControl(bytes, problem);
      RC_ASSERT(decoded.has_value() || !problem.empty());
    }
  }));
}

TEST(Status, BytesStandWhereTheDescriptionHasThem) {
  const Bytes b = encodeStatus({3, 12, true, 1.5F, -2, 0.5F, 4, 0.25F, -0.125F});
  ASSERT_EQ(b.size(), 32U);
  EXPECT_EQ(std::string(b.begin(), b.begin() + 4), "RGrt");
  EXPECT_EQ(Bytes(b.begin() + 4, b.begin() + 8), (Bytes{4, 3, 12, 1}));
  EXPECT_EQ(Bytes(b.begin() + 8, b.begin() + 12), (Bytes{0x00, 0x80, 0xBB, 0x44})) << "1500 mm as float";
  EXPECT_EQ(Bytes(b.begin() + 16, b.begin() + 20), (Bytes{0x00, 0x00, 0x00, 0x3F})) << "0.5 rad";
  std::string problem;
  const auto back = decodeStatus(b, problem);
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, (RobotStatus{3, 12, true, 1.5F, -2, 0.5F, 4, 0.25F, -0.125F}));
}

TEST(Status, WhatIsWrongIsTold) {
  const auto refusedFor = [](std::size_t at, std::uint8_t value) {
    Bytes b = encodeStatus({3, 12, true});
    b[at] = value;
    std::string problem;
    EXPECT_FALSE(decodeStatus(b, problem));
    return problem;
  };
  EXPECT_EQ(refusedFor(0, 'X'), "32 bytes that do not begin with RGrt");
  EXPECT_EQ(refusedFor(4, 3), "RGrt of version 3 in 32 bytes, expected version 4 in 32");
  EXPECT_EQ(refusedFor(5, 0), "player 0, expected 1 to 20");
  EXPECT_EQ(refusedFor(5, 21), "player 21, expected 1 to 20");
  EXPECT_EQ(refusedFor(7, 255), "fallen is 255, expected 0 or 1");
  Bytes b = encodeStatus({3, 12, true});
  b[10] = 0xC0, b[11] = 0x7F;  // not a number
  std::string problem;
  EXPECT_FALSE(decodeStatus(b, problem));
  EXPECT_EQ(problem, "a place or an age that is no finite number");
}

TEST(Message, BytesStandWhereTheDescriptionHasThem) {
  const RobotMessage message{3, 12, RobotMessage::Kind::kReadyAfterInterruption};
  const Bytes b = encodeMessage(message);
  EXPECT_EQ(b, (Bytes{'R', 'G', 'r', 't', 2, 12, 3, 4}));
  std::string problem;
  EXPECT_EQ(decodeMessage(b, problem), message);
  EXPECT_FALSE(decodeMessage(Bytes{'R', 'G', 'r', 't', 2, 12, 3, 5}, problem));
  EXPECT_EQ(problem, "message 5, expected 0 to 4");
}

}  // namespace
}  // namespace murosimf::game_controller
