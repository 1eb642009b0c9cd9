#pragma once

/// @file The game's part of report.json.

#include <nlohmann/json.hpp>

#include "game/game_broadcast.h"
#include "murosimf/scene/scene.h"
#include "murosimf/simulation/contact_statistics.h"
#include "murosimf/simulation/exchange_statistics.h"
#include "murosimf/simulation/integration_statistics.h"
#include "murosimf/simulation/pacer.h"
#include "murosimf/soccer/match_statistics.h"
#include "murosimf/soccer/percept_statistics.h"
#include "murosimf/soccer/referee.h"
#include "murosimf/soccer/trial_referee.h"

namespace murosimf {

/// score {red, blue}, events, goals, shots, saves, own goals, time in play, distance walked per robot.
void addMatch(nlohmann::ordered_json& report, const Referee& referee, const MatchStatistics& statistics);
/// What the game controller has sent, and heard of robots: the last word of each.
void addGameController(nlohmann::ordered_json& report, const GameBroadcast& broadcast);
/// Of trials: how each attempt ended, and how many passed.
void addTrial(nlohmann::ordered_json& report, const TrialReferee& referee);
/// Per robot: recall, precision and distance error of the ball, error of the self-localisation.
void addPercepts(nlohmann::ordered_json& report, const PerceptStatistics& statistics, const Simulation& simulation);
/// Per robot with several levels of detail: seconds at each, exchanges, and what kinematic walking flattened at most.
void addExchanges(nlohmann::ordered_json& report, const Scene& scene, const ExchangeStatistics& statistics,
                  const Simulation& simulation);
/// Per robot whose integrator chooses its steps: how many, its error, and frames that it could not finish.
void addIntegration(nlohmann::ordered_json& report, const IntegrationStatistics& statistics,
                    const Simulation& simulation);
/// Contacts of robots with one another and with posts, a frame.
nlohmann::ordered_json contactFigures(const ContactStatistics::Counts& counts);
nlohmann::ordered_json paceFigures(const PaceReport& pace);

}  // namespace murosimf
