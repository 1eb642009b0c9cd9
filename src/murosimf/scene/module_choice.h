#pragma once

/// @file Which modules a robot of a scenario is linked to: its level of detail, and what was chosen one by one.

#include <vector>

#include "murosimf/linking/linker.h"
#include "murosimf/scene/motion_plan.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// Whether the robot stands on wheels alone: it has wheels or castors and no soles.
bool isOnWheels(const World& world, ObjectId robot);
/// Which motion the robot has from when on. What its level brings depends on whether it stands on wheels.
MotionPlan motionPlanOf(const RobotSettings& robot, Diagnostics& diagnostics, bool on_wheels = false);
/// The robot's modules at all levels of detail of its plan, with their parameters; the assembly is the caller's to fill
/// in. Reports slots that none of its levels has, modules in the place of others, and phases, which modules have none
/// of.
std::vector<Assignment> modulesOf(const RobotSettings& robot, const MotionPlan& plan, const ModuleRegistry& registry,
                                  Diagnostics& diagnostics);

/// Where a choice was written: its module, or else the first thing that was said of it.
SourceLocation placeOf(const ModuleChoice& choice, const RobotSettings& robot);
WrittenValue writtenValue(const SceneValue& value);

}  // namespace murosimf
