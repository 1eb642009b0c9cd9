#pragma once

/// @file The referee acts as a game controller: tells robots' software by UDP how the game stands, and hears their
/// status (docs/game_controller.md).
///
/// Twice a second while the ball is in play or about to be, five times a second when play is stopped, in simulated
/// time. The frame hands over bytes and goes on: sockets have a thread of their own (GameLink).

#include <memory>

#include "murosimf/control/game_controller/game_link.h"
#include "murosimf/scene/scene.h"
#include "murosimf/soccer/referee.h"

namespace murosimf {

/// How the game stands, in the words of game controllers: red at teams[0], blue at teams[1].
game_controller::GameState gameStateOf(const Referee& referee, const GameControllerSettings& settings, long frame);

class GameBroadcast final : public FrameObserver {
 public:
  /// The referee must live longer. @throws client::CannotStart where the sockets cannot be had
  GameBroadcast(const GameControllerSettings& settings, const Referee& referee, const Simulation& simulation);

  void afterFrame(Simulation& simulation) override;
  void archive(StateArchive& archive) override { archive(packet_, last_, last_phase_); }
  const game_controller::GameLink& link() const { return *link_; }

 private:
  const GameControllerSettings settings_;
  const Referee& referee_;
  game_controller::Format format_;
  std::unique_ptr<game_controller::GameLink> link_;
  double frame_length_;
  int packet_ = 0;
  long last_ = -1;                                            // frame of the last packet; -1: none yet
  client::GamePhase last_phase_ = client::GamePhase::kReady;  // that it told
};

}  // namespace murosimf
