#pragma once

/// @file The UDP packets of game controllers and robots, byte by byte: little endian, without gaps.
///
/// format  league                                         header         bytes  teams at  a team  a player
/// kHsl19  Humanoid Soccer League 2026                    RGme 19        198    18        90      4
/// kSpl18  Standard Platform League 2025/26               RGme 18        118    18        50      2
/// kHl15   Humanoid League 2025                           RGme 15        118    18        50      2
/// kHl12   Humanoid League until 2024, virtual season     RGme 12, 0     688    24        332     6
/// Sources: game_controller_msgs/headers/RoboCupGameControlData.h of RoboCup-HumanoidSoccerLeague/GameController and
/// RoboCup-SPL/GameController3, new_RoboCupGameControlData.h and include/RoboCupGameControlData.h of
/// RoboCup-Humanoid-TC/GameController. docs/game_controller.md lists what each format cannot say, and what it says
/// instead.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/control/game_controller/game_state.h"

namespace murosimf::game_controller {

enum class Format : std::uint8_t { kHsl19, kSpl18, kHl15, kHl12 };

using Bytes = std::vector<std::uint8_t>;

/// The control data of a game controller. Numbers that do not fit are taken as the nearest that do.
Bytes encodeControl(const GameState& game, Format format);

struct DecodedControl {
  GameState game;
  Format format = Format::kHsl19;
};
/// @param problem  gets what is wrong where nothing is returned
std::optional<DecodedControl> decodeControl(std::span<const std::uint8_t> bytes, std::string& problem);

/// What a robot tells of itself: "RGrt", version 4, 32 bytes, in all formats but kHl12.
struct RobotStatus {
  int player = 0, team = 0;
  bool fallen = false;
  float x = 0, y = 0, heading = 0;  ///< in the team's own frame [m], [rad]; mm on the wire
  float ball_age = -1;              ///< [s]; -1: never seen
  float ball_x = 0, ball_y = 0;     ///< in the robot's frame [m]; mm on the wire
  friend bool operator==(const RobotStatus&, const RobotStatus&) = default;
};
/// The same of kHl12: "RGrt", version 2, 8 bytes.
struct RobotMessage {
  enum class Kind : std::uint8_t { kPenalise, kUnpenalise, kAlive, kGoalkeeper, kReadyAfterInterruption };
  int player = 0, team = 0;
  Kind kind = Kind::kAlive;
  friend bool operator==(const RobotMessage&, const RobotMessage&) = default;
};

Bytes encodeStatus(const RobotStatus& status);
Bytes encodeMessage(const RobotMessage& message);
std::optional<RobotStatus> decodeStatus(std::span<const std::uint8_t> bytes, std::string& problem);
std::optional<RobotMessage> decodeMessage(std::span<const std::uint8_t> bytes, std::string& problem);

}  // namespace murosimf::game_controller
