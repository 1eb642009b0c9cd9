#pragma once

/// @file Everybody who watches a game: referee, statistics, percepts. The same for every program that plays scenarios,
/// so that a checkpoint of the one can be continued by the other.

#include <memory>
#include <string>

#include "game/game_broadcast.h"
#include "game/hash_log.h"
#include "murosimf/scene/scene.h"
#include "murosimf/simulation/contact_statistics.h"
#include "murosimf/simulation/exchange_statistics.h"
#include "murosimf/simulation/integration_statistics.h"
#include "murosimf/simulation/percept_overlay.h"
#include "murosimf/soccer/match_statistics.h"
#include "murosimf/soccer/percept_statistics.h"
#include "murosimf/soccer/referee.h"
#include "murosimf/soccer/trial_referee.h"

namespace murosimf {

/// Registers with the simulation and its control loop, which must live as long. Call before the first frame.
class GameObservers {
 public:
  GameObservers(const Scene& scene, Simulation& simulation);

  /// Null where the scenario has no referee; the next two likewise.
  const Referee* referee() const { return referee_.get(); }
  /// Null where the referee judges no trial.
  const TrialReferee* trial() const { return dynamic_cast<const TrialReferee*>(referee_.get()); }
  /// A trial's last attempt has been judged: there is nothing more to see.
  bool finished() const { return trial() != nullptr && referee_->phase() == client::GamePhase::kFinished; }
  /// Null where the scenario's referee is no game controller.
  const GameBroadcast* broadcast() const { return broadcast_.get(); }
  const MatchStatistics* match() const { return match_.get(); }
  const PerceptStatistics* percepts() const { return percepts_.get(); }
  const PerceptKeeper& keeper() const { return keeper_; }
  const ExchangeStatistics& exchanges() const { return exchanges_; }
  const IntegrationStatistics& integration() const { return integration_; }
  const ContactStatistics& contacts() const { return contacts_; }
  const HashLog& hashes() const { return hashes_; }

  /// What a robot is at, and how hard its motion is to integrate where its integrator chooses its steps.
  std::string tagOf(int robot) const;
  /// "red 1 : 0 blue"; empty without a referee.
  std::string scoreText() const;
  /// Time, and the score where there is a referee, for pictures.
  std::string caption(double time) const;

 private:
  const Simulation& simulation_;
  std::unique_ptr<Referee> referee_;
  std::unique_ptr<GameBroadcast> broadcast_;
  std::unique_ptr<PerceptStatistics> percepts_;
  std::unique_ptr<MatchStatistics> match_;
  PerceptKeeper keeper_;
  ExchangeStatistics exchanges_;
  IntegrationStatistics integration_;
  ContactStatistics contacts_;
  HashLog hashes_;
};

}  // namespace murosimf
