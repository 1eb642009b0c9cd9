#pragma once

/// @file Gives the cameras of a robot their lenses: the robot file's, or the calibration that the scenario names.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/robot/calibration_file.h"
#include "murosimf/robot/robot_model.h"
#include "murosimf/scene/scene.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// Reads every calibration once, however many cameras and robots use it, and tells once that a lens is continued.
class LensBuilder {
 public:
  explicit LensBuilder(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Sets the constant kCameraModel of all cameras of `robot`. Parameter `lens` of a camera of the scenario names a
  /// calibration, looked for like robot files; where that tells no size of the picture, it is the robot file's.
  /// `extrapolate`, there or in the robot file, lets a lens that does not see its whole picture be continued linearly.
  void apply(World& world, ObjectId robot, const RobotSettings& settings, const RobotModel& model);

 private:
  struct Choice {
    CameraModel lens;
    SourceLocation where;
    bool extrapolate = false;
  };
  Choice choose(const RobotSettings& settings, const CameraMount& mount);
  void replaceLens(const NamedValue& parameter, const CameraMount& mount, Choice& choice);
  const Calibration* read(const std::string& name, const SourceLocation& where);
  CameraModel continuedWhereNeeded(const Choice& choice, const CameraMount& mount);

  Diagnostics& diagnostics_;
  std::map<std::string, std::optional<Calibration>> files_;  ///< by the path; by the name if not found
  std::vector<std::pair<CameraModel, CameraModel>> continued_;
};

}  // namespace murosimf
