#include "murosimf/scene/lens_builder.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/scene/robot_reader.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

bool coversItsPicture(const CameraModel& camera) {
  try {
    checkCamera(camera);
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

}  // namespace

const Calibration* LensBuilder::read(const std::string& name, const SourceLocation& where) {
  const std::string found = findDataFile(name, where.file).string();
  const auto [at, fresh] = files_.emplace(found.empty() ? name : found, std::nullopt);
  if (fresh && found.empty()) {
    diagnostics_.error(where, fmt::format("there is no calibration {}", whereLooked(name, where.file)));
  } else if (fresh) {
    at->second = readCalibrationFile(found, diagnostics_);
  }
  return at->second ? &*at->second : nullptr;
}

void LensBuilder::replaceLens(const NamedValue& parameter, const CameraMount& mount, Choice& choice) {
  const auto* name = std::get_if<std::string>(&*parameter.value);
  if (name == nullptr || name->empty()) {
    return diagnostics_.error(parameter.value.where, "lens is no text, expected the name of a calibration file");
  }
  const Calibration* calibration = read(*name, parameter.value.where);
  if (calibration == nullptr) return;
  choice.lens = calibration->camera;
  choice.where = parameter.value.where;
  if (!calibration->has_size) choice.lens.width = mount.lens.width, choice.lens.height = mount.lens.height;
}

LensBuilder::Choice LensBuilder::choose(const RobotSettings& settings, const CameraMount& mount) {
  Choice choice{mount.lens, mount.where, mount.extrapolate};
  for (const ModuleChoice& camera : settings.cameras) {
    if (camera.slot != mount.name) continue;
    for (const NamedValue& parameter : camera.parameters) {
      if (parameter.name == "lens") replaceLens(parameter, mount, choice);
      if (parameter.name != "extrapolate") continue;
      if (const auto* truth = std::get_if<bool>(&*parameter.value)) {
        choice.extrapolate = *truth;
      } else {
        diagnostics_.error(parameter.value.where, "extrapolate is neither true nor false");
      }
    }
  }
  return choice;
}

CameraModel LensBuilder::continuedWhereNeeded(const Choice& choice, const CameraMount& mount) {
  for (const auto& [described, continued] : continued_) {
    if (described == choice.lens) return continued;
  }
  CameraModel lens = choice.lens;
  if (!coversItsPicture(lens)) {
    if (const std::optional<double> angle = continueLinearly(lens)) {
      diagnostics_.warning(choice.where,
                           fmt::format("camera {}: the lens does not see its whole picture and is continued "
                                       "linearly from {:.4g} deg off its axis on",
                                       mount.name, *angle * 180 / kPi));
    }
  }
  continued_.emplace_back(choice.lens, lens);
  return lens;
}

void LensBuilder::apply(World& world, ObjectId robot, const RobotSettings& settings, const RobotModel& model) {
  for (const CameraMount& mount : model.cameras) {
    const Choice choice = choose(settings, mount);
    const CameraModel lens = choice.extrapolate ? continuedWhereNeeded(choice, mount) : choice.lens;
    world.set(world.find(world.path(robot) + "." + mount.name), kCameraModel, lens, choice.where);
  }
}

}  // namespace murosimf
