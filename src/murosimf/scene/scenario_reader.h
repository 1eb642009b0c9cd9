#pragma once

/// @file Scenario (TOML text) -> Scene. The format: docs/scenario_format.md.
///
/// Everything wrong in a file is reported at once, with file, line and column (or the `--set` it came from), except
/// that the first syntax error ends the reading.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf {

/// @param overrides `PATH=VALUE` each, as of `--set`, the later over the earlier (scene/override.h)
/// @return nothing after an error
std::optional<Scene> readScenario(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                                  Diagnostics& diagnostics);

/// The same of a text; `file` names it in messages, and files named in it are looked for beside it.
std::optional<Scene> readScenarioText(std::string_view text, const std::filesystem::path& file,
                                      const std::vector<std::string>& overrides, Diagnostics& diagnostics);

/// Writes every value of a scene as a scenario that reads back to the same values.
std::string writeScenario(const Scene& scene);

}  // namespace murosimf
