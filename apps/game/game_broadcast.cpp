#include "game/game_broadcast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace murosimf {

namespace {

using game_controller::Format;
using game_controller::GameLinkSettings;
using game_controller::GameState;
using game_controller::State;
using game_controller::TeamState;

constexpr double kPlayingPeriod = 0.5, kStoppedPeriod = 0.2;  // [s]
constexpr int kRedColour = 1, kBlueColour = 0;
constexpr int kMessageBudget = 12000;  // of a half [Humanoid Soccer League 2026]; nobody counts messages here

Format formatNamed(const std::string& name) {
  if (name == "spl18") return Format::kSpl18;
  if (name == "hl15") return Format::kHl15;
  return name == "hl12" ? Format::kHl12 : Format::kHsl19;
}

GameLinkSettings linkSettings(const GameControllerSettings& s) {
  GameLinkSettings link;
  link.host = *s.host, link.port = *s.port, link.broadcast = *s.broadcast;
  link.listen_host = *s.listen, link.return_port = *s.return_port;
  link.allowed.clear();
  std::istringstream hosts(*s.allow);
  for (std::string host; hosts >> host;) link.allowed.push_back(host);
  return link;
}

State stateOf(client::GamePhase phase) {
  switch (phase) {
    case client::GamePhase::kReady:
      return State::kReady;
    case client::GamePhase::kSet:
      return State::kSet;
    case client::GamePhase::kPlaying:
      return State::kPlaying;
    case client::GamePhase::kFinished:
      return State::kFinished;
  }
  return State::kInitial;
}

TeamState teamStateOf(const Referee& referee, Team team, int number) {
  TeamState state;
  state.number = number;
  state.field_colour = state.keeper_colour = team == Team::kRed ? kRedColour : kBlueColour;
  state.goalkeeper = 1;
  state.score = referee.score(team);
  state.message_budget = kMessageBudget;
  return state;
}

int playersOf(const MatchSettings& match, Team team) {
  return static_cast<int>(std::count_if(match.robots.begin(), match.robots.end(),
                                        [team](const MatchRobot& robot) { return robot.team == team; }));
}

}  // namespace

GameState gameStateOf(const Referee& referee, const GameControllerSettings& settings, long frame) {
  GameState game;
  game.players_per_team = std::max(playersOf(referee.match(), Team::kRed), playersOf(referee.match(), Team::kBlue));
  game.state = stateOf(referee.phase());
  game.stopped = referee.phase() == client::GamePhase::kReady;
  game.first_half = !referee.inSecondHalf();
  const int kicking = referee.kickoffTeam() == Team::kRed ? *settings.red_number : *settings.blue_number;
  game.kicking_team = referee.ballInPlay() ? game_controller::kNobody : kicking;
  game.seconds_remaining = static_cast<int>(std::ceil(referee.secondsLeft(frame) - 1e-9));
  game.teams = {teamStateOf(referee, Team::kRed, *settings.red_number),
                teamStateOf(referee, Team::kBlue, *settings.blue_number)};
  return game;
}

GameBroadcast::GameBroadcast(const GameControllerSettings& settings, const Referee& referee,
                             const Simulation& simulation)
    : settings_(settings),
      referee_(referee),
      format_(formatNamed(*settings.format)),
      frame_length_(simulation.frameLength()) {
  try {
    link_ = std::make_unique<game_controller::GameLink>(linkSettings(settings));
  } catch (const std::exception& problem) {
    throw client::CannotStart(fmt::format("game_controller: {}", problem.what()));
  }
}

void GameBroadcast::afterFrame(Simulation& simulation) {
  const long frame = simulation.frame();
  const client::GamePhase phase = referee_.phase();
  const double period = phase == client::GamePhase::kPlaying ? kPlayingPeriod : kStoppedPeriod;
  const bool due = last_ < 0 || phase != last_phase_ ||
                   static_cast<double>(frame - last_) * frame_length_ >= period - frame_length_ / 2;
  if (!due) return;
  GameState game = gameStateOf(referee_, settings_, frame);
  game.packet = packet_;
  packet_ = (packet_ + 1) % 256;
  last_ = frame, last_phase_ = phase;
  link_->send(encodeControl(game, format_));
}

}  // namespace murosimf
