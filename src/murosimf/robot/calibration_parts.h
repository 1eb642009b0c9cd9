#pragma once

/// @file What stands in a calibration file, number by number, before it becomes a camera.

#include <optional>
#include <string>
#include <vector>

#include "murosimf/world/diagnostics.h"

namespace murosimf::calibration {

/// Numbers under the name that the file gives them.
struct Numbers {
  std::string name;
  std::vector<double> values;
  SourceLocation where;
};
struct Word {
  std::string name, text;
  SourceLocation where;
};

/// Of YAML the camera matrix, of Bouguet's files fc, cc and alpha_c.
struct Parts {
  std::optional<Numbers> matrix, focal, centre, skew, distortion, width, height;
  std::optional<Word> model;
};

/// Report what cannot be read as such; keys that are missing are the caller's matter.
Parts readYaml(const std::string& text, const std::string& file, Diagnostics& diagnostics);
Parts readMatlab(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace murosimf::calibration
