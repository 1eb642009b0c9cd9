#pragma once

/// @file Which files a run reads besides its scenario: robots, their meshes, lenses, servos, textures.
///
/// They are found as readers find them, but without knowing the readers: each text in the scenario, in the overrides
/// and between quotes in a file found so far that names an existing file counts as one. That takes in a file too many
/// rather than one too few: a run is then played again without need, never taken for another one.

#include <filesystem>
#include <string>
#include <vector>

namespace murosimf {

struct InputFile {
  std::string name;  ///< as written
  std::filesystem::path file;
};

/// Sorted by name, then by path; without the scenario itself. A scenario that is no TOML gives none.
std::vector<InputFile> inputFiles(const std::filesystem::path& scenario, const std::vector<std::string>& overrides);

}  // namespace murosimf
