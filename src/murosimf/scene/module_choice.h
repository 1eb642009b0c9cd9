#pragma once

/// @file Which modules a robot of a scenario is linked to: its level of detail, and what was chosen one by one.

#include <vector>

#include "murosimf/linking/linker.h"
#include "murosimf/modules/camera/robot_camera.h"
#include "murosimf/robot/robot_model.h"
#include "murosimf/scene/motion_plan.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// Which motion the robot has from when on.
MotionPlan motionPlanOf(const RobotSettings& robot, Diagnostics& diagnostics);
/// The robot's modules at all levels of detail of its plan, with their parameters; the assembly is the caller's to fill
/// in. Reports slots that none of its levels has, modules in the place of others, and phases, which modules have none
/// of.
std::vector<Assignment> modulesOf(const RobotSettings& robot, const MotionPlan& plan, const ModuleRegistry& registry,
                                  Diagnostics& diagnostics);

/// How a camera of the robot takes pictures.
struct CameraChoice {
  bool on = true;
  RobotCameraSettings settings;
};
/// @param control_period  [s]; pictures are delivered with sensor frames, so none may come more often
CameraChoice cameraChoice(const RobotSettings& robot, const CameraMount& mount, double control_period,
                          Diagnostics& diagnostics);
/// Reports cameras that the scenario names but the robot does not have.
void reportUnknownCameras(const RobotSettings& robot, const RobotModel& model, Diagnostics& diagnostics);

WrittenValue writtenValue(const SceneValue& value);

}  // namespace murosimf
