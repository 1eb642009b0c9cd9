#pragma once

/// @file Reads robots from URDF with this project's extensions (docs/robot_format.md).
///
/// Every mistake in the file is reported, with its line, before the reader gives up; nothing that a file may hold makes
/// it crash. Warnings leave a model that can be used. tinyxml2 knows lines but no columns, so columns are 0.

#include <optional>
#include <string>

#include "murosimf/robot/robot_model.h"

namespace murosimf {

/// The robot, or nothing when at least one error was reported.
using ReadResult = std::optional<RobotModel>;

/// Reads a file. Adds to diagnostics; never throws for what the file holds.
ReadResult readUrdf(const std::string& path, Diagnostics& diagnostics);

/// Reads text that was loaded elsewhere; `file` is the name used in messages.
ReadResult readUrdfText(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace murosimf
