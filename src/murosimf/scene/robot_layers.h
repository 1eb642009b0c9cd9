#pragma once

/// @file What holds for one robot, out of the layers in which a scenario speaks of it.
///
/// From the lowest: [robots.all], [teams.TEAM], [robots.TEAM.NUMBER], then the same three of `--set`. A higher layer
/// replaces single keys of a lower one. Naming a module takes the parameters of another module away that a lower
/// layer had named for the same slot; those of the same module stay.

#include <string_view>

#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// Slots of a robot that take one module each.
inline constexpr std::string_view kModuleSlots[] = {
    "motion",  "electronics", "actuation", "velocities", "kinematics",    "collision", "contact", "integration",
    "sensing", "pressure",    "torque",    "limits",     "accelerations", "touch",     "force",   "recoil"};

/// The key of a robot's table that its name alone stands for: `control = "player"` is `control = {program = "player"}`.
std::string_view nameKeyOf(std::string_view table);

/// Brings the tables of robots and teams into one form: modules given by name become tables, properties get their
/// dotted names, poses in arrays become tables. Works on a scenario's tree and on a tree of `--set`; leaves what has
/// the wrong type for the reader to report.
void normaliseRobotTables(TextNode& scenario);

/// The robot's table over all layers, of normalised trees.
TextNode layeredRobot(const TextNode& scenario, const TextNode& changes, std::string_view team,
                      std::string_view number);

}  // namespace murosimf
