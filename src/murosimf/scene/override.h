#pragma once

/// @file `--set PATH=VALUE`: changes of a scenario from the command line.
///
/// PATH names a key as in the file, joined by dots (`robots.red.1.motion.period`); a part with dots of its own stands
/// in quotes. VALUE is a TOML value; a bare word is a text. Errors name `--set PATH=VALUE` as their place.

#include <string_view>

#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// Writes the assignment into a tree of changes, over what earlier assignments wrote there.
/// @return false after an error: no `=`, a part of the path that is empty, a value that cannot be read.
bool applyOverride(TextNode& changes, std::string_view assignment, Diagnostics& diagnostics);

}  // namespace murosimf
