#pragma once

/// @file How a game stands, as game controllers of all leagues tell it, in words that none of them owns.
///
/// packets.h turns it into the bytes of each format and back. Times in whole seconds, as in the packets.

#include <array>
#include <cstdint>

namespace murosimf::game_controller {

enum class State : std::uint8_t { kInitial, kReady, kSet, kPlaying, kFinished };
enum class Phase : std::uint8_t { kNormal, kPenaltyShootout, kExtraTime, kTimeout };
enum class SetPlay : std::uint8_t {
  kNone,
  kDirectFreeKick,
  kIndirectFreeKick,
  kPenaltyKick,
  kThrowIn,
  kGoalKick,
  kCornerKick
};
enum class Penalty : std::uint8_t {
  kNone,
  kIllegalPosition,
  kMotionInSet,
  kLocalGameStuck,
  kIncapable,
  kPickUp,
  kBallHolding,
  kLeavingField,
  kArmsOrHands,
  kPushing,
  kSentOff,
  kSubstitute,
  kIllegalPositionInSet,
  kPlayerStance,
  kIllegalAttack,
  kIllegalDefence,
  kService,
  kManual
};

inline constexpr int kMostPlayers = 20;
inline constexpr int kNobody = -1;  ///< as a team's number

struct PlayerState {
  Penalty penalty = Penalty::kNone;
  int seconds_left = 0;  ///< of the penalty
  int warnings = 0, yellow_cards = 0, red_cards = 0;
  friend bool operator==(const PlayerState&, const PlayerState&) = default;
};

struct TeamState {
  int number = 0;
  int field_colour = 0, keeper_colour = 0;  ///< 0 blue, 1 red, 2 yellow, 3 black, 4 white, 5 green, 6 orange, 7 purple,
                                            ///< 8 brown, 9 grey
  int goalkeeper = 0;                       ///< jersey number; 0: none
  int score = 0;
  int penalty_shots = 0;           ///< taken in the shoot-out
  std::uint16_t shots_scored = 0;  ///< one bit a shot
  int message_budget = 0;
  std::array<PlayerState, kMostPlayers> players{};  ///< player n at place n - 1
  friend bool operator==(const TeamState&, const TeamState&) = default;
};

struct GameState {
  int packet = 0;  ///< counts, modulo 256
  int players_per_team = 4;
  int competition = 0;   ///< type of the competition, a number of the league's
  int round = 0;         ///< 0 round robin, 1 play-off
  bool stopped = false;  ///< play is interrupted
  Phase phase = Phase::kNormal;
  State state = State::kInitial;
  SetPlay set_play = SetPlay::kNone;
  bool first_half = true;
  int kicking_team = kNobody;  ///< number of the team that has the next kick-off, free kick, ...
  int seconds_remaining = 600;
  int secondary_seconds = 0;  ///< of getting ready, until the ball is free, ...
  std::array<TeamState, 2> teams{};
  friend bool operator==(const GameState&, const GameState&) = default;
};

}  // namespace murosimf::game_controller
