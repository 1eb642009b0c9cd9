#pragma once

/// @file Errors of sensors at the levels of detail of a robot that goes through several.

#include <vector>

#include "murosimf/linking/linker.h"

namespace murosimf {

/// Modules of the concern "errors" hold at the levels that have their sensor: drops them at those that lack it. Where
/// no level has it they stay, for the linker to complain of.
/// @param assignments  of one robot, at all its levels
void dropErrorsWithoutSensor(std::vector<Assignment>& assignments, const ModuleRegistry& registry);

}  // namespace murosimf
