#pragma once

/// @file How wrong the oracles of a robot of a scenario are.
///
///     [robots.all.cameras.head]
///     module = "oracle"
///     distance_noise = 0.05       # of all kinds
///     ball_distance_noise = 0.02  # of one

#include <optional>

#include "murosimf/control/pose_oracle.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// Reads a camera's parameters of level "oracle", all but those of its lens. Reports what is wrong.
void readSightErrors(const ModuleChoice& camera, ErrorsByKind& errors, Diagnostics& diagnostics);

/// Who tells the robot where it stands: nobody, unless the scenario or the level of detail says so.
std::optional<PoseOracleSettings> localisationChoice(const RobotSettings& robot, Diagnostics& diagnostics);

}  // namespace murosimf
