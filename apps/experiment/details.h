#pragma once

/// @file The details of a scenario: what could be simulated more cheaply, robot by robot and module by module.

#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf {

/// One key of the scenario with the values to choose from.
struct Detail {
  std::string path;                  ///< as of `--set`: "robots.red.1.level"
  std::vector<std::string> choices;  ///< from full detail to the cheapest, in words of the scenario
  std::optional<std::size_t>
      within;  ///< a detail without whose first choice this one means nothing: a camera's shadows
};

/// Which choice each detail has; all 0: full detail.
using Choices = std::vector<std::size_t>;

/// Whether the key means anything with these choices.
bool isMeant(const std::vector<Detail>& details, const Choices& choices, std::size_t detail);

/// PATH=VALUE of all details that mean something.
std::vector<std::string> overridesOf(const std::vector<Detail>& details, const Choices& choices);

/// Of each robot: `level` (full, fast, kinematic) unless the scenario names its motion; each camera that is not
/// switched off (its pictures, oracle, none) with its shadows and antialias where these are on; localisation (none,
/// oracle) where there is control software; `collision` (as it is, feet_only); each further module of `modules`.
/// @param fixed  overrides of the user, PATH=VALUE: what they name is no detail
/// @param only  beginnings of paths, "robots.red.1": all else stays as the scenario says; none: everything
/// Robot files that cannot be read are reported.
std::vector<Detail> detailsOf(const Scene& scene, const std::vector<std::string>& fixed,
                              const std::vector<std::string>& only, Diagnostics& diagnostics);

}  // namespace murosimf
