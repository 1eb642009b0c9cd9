#include "game/game_observers.h"

#include <fmt/format.h>

#include "game/match_setup.h"
#include "murosimf/simulation/overview.h"

namespace murosimf {

GameObservers::GameObservers(const Scene& scene, Simulation& simulation)
    : simulation_(simulation), keeper_(*simulation.control()), exchanges_(simulation), integration_(simulation) {
  ControlLoop& control = *simulation.control();
  if (*scene.referee.enabled) {
    const MatchSettings match = matchSettings(scene, simulation.world());
    referee_ = makeReferee(match, simulation);
    simulation.observe(referee_.get());
    if (*scene.game_controller.role == "send") {
      broadcast_ = std::make_unique<GameBroadcast>(scene.game_controller, *referee_, simulation);
      simulation.observe(broadcast_.get());
    }
    percepts_ = std::make_unique<PerceptStatistics>(match, simulation);
    control.observe(percepts_.get());
    simulation.observe(percepts_.get());
    match_ = std::make_unique<MatchStatistics>(*referee_, simulation, percepts_.get());
    simulation.observe(match_.get());
  }
  control.observe(&keeper_);
  simulation.observe(&exchanges_);
  simulation.observe(&integration_);
  simulation.observe(&contacts_);
  simulation.observe(&hashes_);
}

std::string GameObservers::tagOf(int robot) const {
  if (simulation_.guard().frozen(static_cast<std::size_t>(robot))) return "frozen";
  const std::string activity(keeper_.activity(robot));
  const int substeps = integration_.substeps(robot);
  if (substeps == 0) return activity;
  return fmt::format("{} {} steps, error {:.0e}", activity, substeps, integration_.error(robot));
}

std::string GameObservers::scoreText() const { return referee_ == nullptr ? "" : referee_->scoreText(); }

std::string GameObservers::caption(double time) const {
  if (referee_ == nullptr) return fmt::format("T {:.2f}", time);
  if (referee_->match().rules != Rules::kMatch) return fmt::format("T {:.2f}  {}", time, referee_->scoreText());
  return gameCaption(time, referee_->score(Team::kRed), referee_->score(Team::kBlue));
}

}  // namespace murosimf
