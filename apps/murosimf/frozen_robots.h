#pragma once

/// @file What a run tells of robots whose state was no number any more.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// Writes the last steps of each into a table in this folder. @return a warning a robot, with the name of its file
/// @throws std::runtime_error when a file cannot be written
std::string writeFrozenRobots(const Simulation& simulation, const std::filesystem::path& directory);
/// {robot, time, what, steps} each; nothing is added when there are none.
void addFrozenRobots(nlohmann::ordered_json& report, const Simulation& simulation);

}  // namespace murosimf
