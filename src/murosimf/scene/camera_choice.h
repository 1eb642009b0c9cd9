#pragma once

/// @file How the cameras of a robot of a scenario take pictures.

#include <optional>

#include "murosimf/modules/camera/oracle_camera.h"
#include "murosimf/modules/camera/robot_camera.h"
#include "murosimf/robot/robot_model.h"
#include "murosimf/scene/scene.h"

namespace murosimf {

/// How a camera of the robot looks: as the scenario says, else as the level of detail does.
struct CameraChoice {
  bool on = true;
  RobotCameraSettings settings;
  std::optional<OracleSettings> oracle;  ///< given: level "oracle", no pictures
  SourceLocation where;                  ///< of the module's name, or of what stands for it
};
/// @param control_period  [s]; pictures are delivered with sensor frames, so none may come more often
/// @param makers  whom scenarios can name
CameraChoice cameraChoice(const RobotSettings& robot, const CameraMount& mount, double control_period,
                          const PictureMakers& makers, Diagnostics& diagnostics);
/// Reports cameras that the scenario names but the robot does not have.
void reportUnknownCameras(const RobotSettings& robot, const RobotModel& model, Diagnostics& diagnostics);

}  // namespace murosimf
