#pragma once

/// @file What the commands of a script do; their words are listed in script.h.

#include <map>
#include <string>
#include <vector>

#include "murosimf-view/script.h"
#include "murosimf-view/window.h"

namespace murosimf {

struct ScriptCommand {
  std::size_t words = 0;  ///< that it needs behind it
  /// @throws std::runtime_error naming the line for something that is not there or not as expected
  void (*act)(ScriptHand& hand, Viewer& viewer, const ScriptLine& line) = nullptr;
};

/// By name.
const std::map<std::string, ScriptCommand>& scriptCommands();

}  // namespace murosimf
