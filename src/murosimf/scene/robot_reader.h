#pragma once

/// @file Reads what a scenario says of one robot.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// Whose keys a table holds: one robot's, or defaults of many (no poses, nothing must be there).
enum class RobotTable { kRobot, kDefaults };

/// @param table normalised and, for kRobot, over all layers (robot_layers.h)
/// @param name of the table in messages, "robots.red.1"
/// @param more keys that are allowed besides a robot's
RobotSettings readRobot(const TextNode& table, RobotTable kind, std::string_view name,
                        const std::filesystem::path& scenario, const std::vector<std::string>& more,
                        Diagnostics& diagnostics);

/// Folders in which files named in a scenario are looked for, in this order: the scenario's, the one above it, the
/// working folder, the data installed beside the program.
std::vector<std::filesystem::path> dataFolders(const std::filesystem::path& scenario);
/// The first existing file of that name, or an empty path.
std::filesystem::path findDataFile(const std::string& name, const std::filesystem::path& scenario);
/// For messages: the name, where it was looked for in vain, and the nearest file there.
std::string whereLooked(const std::string& name, const std::filesystem::path& scenario);

}  // namespace murosimf
