#pragma once

/// @file report.json: what a run was, what came out, and how long it took.

#include <nlohmann/json.hpp>
#include <string>

#include "game/hash_log.h"
#include "murosimf/scene/scene.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// Sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t hash);

/// What every run has: times, threads, hashes, stages. The game's own results are added by the caller.
/// @param wall_seconds  time of the frames alone, without building the world and writing results
nlohmann::ordered_json basicReport(const Scene& scene, const Simulation& simulation, const HashLog& hashes,
                                   double simulated_seconds, double wall_seconds);

/// Writes through a temporary name, so that nobody reads half a report. @throws std::runtime_error naming the file.
void writeReport(const nlohmann::ordered_json& report, const std::string& file);

}  // namespace murosimf
