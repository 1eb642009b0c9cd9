#include "murosimf/scene/camera_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/module_choice.h"
#include "murosimf/scene/oracle_choice.h"
#include "murosimf/scene/picture_chain.h"

namespace murosimf {

namespace {

/// Reads one number parameter of a camera into `out`; reports one that is no number in [lowest, highest].
void readNumber(const NamedValue& parameter, double lowest, double highest, double& out, Diagnostics& diagnostics) {
  const auto* number = std::get_if<double>(&*parameter.value);
  if (number == nullptr || !(*number >= lowest && *number <= highest)) {
    diagnostics.error(parameter.value.where,
                      fmt::format("{} is {}, expected a number from {} to {}", parameter.name,
                                  number == nullptr ? "no number" : fmt::format("{}", *number), lowest, highest));
    return;
  }
  out = *number;
}

/// Reads one switch of a camera.
void readSwitch(const NamedValue& parameter, bool& out, Diagnostics& diagnostics) {
  const auto* value = std::get_if<bool>(&*parameter.value);
  if (value == nullptr) {
    diagnostics.error(parameter.value.where, fmt::format("{} is neither true nor false", parameter.name));
    return;
  }
  out = *value;
}

/// The names of parameters that every level of detail has: LensBuilder reads them.
bool isOfLens(const NamedValue& parameter) { return parameter.name == "lens" || parameter.name == "extrapolate"; }

/// Says so where a maker cannot do what is wanted of it.
void refuse(const PictureMakerKind& kind, std::string_view what, const SourceLocation& where,
            Diagnostics& diagnostics) {
  diagnostics.error(where, fmt::format("camera module {} has no {}, expected a camera without it, or module = "
                                       "\"ray_caster\"",
                                       kind.name, what));
}

/// Shutters are found out when the whole chain is known.
void checkShutter(const ModuleChoice& choice, const RobotCameraSettings& settings, Diagnostics& diagnostics) {
  if (settings.maker->can.shutter || settings.isInstant()) return;
  const auto chain = std::find_if(choice.parameters.begin(), choice.parameters.end(),
                                  [](const NamedValue& parameter) { return parameter.name == "chain"; });
  refuse(*settings.maker, settings.shutter.readout > 0 ? "rolling_shutter" : "motion_blur", chain->value.where,
         diagnostics);
}

void readSwitch(const NamedValue& parameter, const PictureMakerKind& kind, bool can, bool& out,
                Diagnostics& diagnostics) {
  readSwitch(parameter, out, diagnostics);
  if (out && !can) refuse(kind, parameter.name, parameter.value.where, diagnostics);
}

void readPictures(const ModuleChoice& choice, RobotCameraSettings& settings, Diagnostics& diagnostics) {
  const PictureMakerKind& kind = *settings.maker;
  for (const NamedValue& parameter : choice.parameters) {
    if (PictureChainReader::owns(parameter) || isOfLens(parameter)) continue;
    if (parameter.name == "noise") {
      readNumber(parameter, 0, 0.5, settings.noise, diagnostics);
    } else if (parameter.name == "gain") {
      readNumber(parameter, 0.01, 100, settings.gain, diagnostics);
    } else if (parameter.name == "antialias") {
      readSwitch(parameter, kind, kind.can.antialias, settings.antialias, diagnostics);
    } else if (parameter.name == "shadows") {
      readSwitch(parameter, kind, kind.can.shadows, settings.shadows, diagnostics);
    } else {
      std::vector<std::string> known{"noise", "gain", "antialias", "shadows", "lens", "extrapolate"};
      for (std::string& name : PictureChainReader::knownParameters()) known.push_back(std::move(name));
      diagnostics.error(parameter.name_where,
                        fmt::format("module {} has no parameter \"{}\"; it knows {}{}", kind.name, parameter.name,
                                    fmt::join(known, ", "), didYouMean(parameter.name, known)));
    }
  }
  PictureChainReader(choice, diagnostics).read(settings);
  checkShutter(choice, settings, diagnostics);
}

/// The module of a camera: what is written, else what the level of detail brings.
std::string moduleOf(const RobotSettings& robot, const ModuleChoice* choice, const PictureMakers& makers,
                     Diagnostics& diagnostics) {
  const std::string usual = *robot.level == "oracle" ? "oracle" : rayCasterKind()->name;
  if (choice == nullptr || choice->module->empty()) return usual;
  const Located<std::string>& module = choice->module;
  std::vector<std::string> known{"none"};
  for (const auto& [name, kind] : makers) known.push_back(name);
  known.emplace_back("oracle");
  if (std::find(known.begin(), known.end(), *module) == known.end()) {
    diagnostics.error(module.where, fmt::format("{}: unknown camera module \"{}\"; expected one of {}{}", robot.path(),
                                                *module, fmt::join(known, ", "), didYouMean(*module, known)));
    return usual;
  }
  const auto maker = makers.find(*module);
  if (maker == makers.end() || maker->second->missing.empty()) return *module;
  diagnostics.error(module.where, fmt::format("camera module {}: {}", *module, maker->second->missing));
  return usual;
}

}  // namespace

CameraChoice cameraChoice(const RobotSettings& robot, const CameraMount& mount, double control_period,
                          const PictureMakers& makers, Diagnostics& diagnostics) {
  CameraChoice result;
  SourceLocation period_where = mount.where;
  double &period = result.settings.period, &phase = result.settings.phase;
  period = mount.period, phase = mount.phase;
  const auto named = std::find_if(robot.cameras.begin(), robot.cameras.end(),
                                  [&](const ModuleChoice& choice) { return choice.slot == mount.name; });
  const ModuleChoice* choice = named == robot.cameras.end() ? nullptr : &*named;
  const std::string module = moduleOf(robot, choice, makers, diagnostics);
  result.on = module != "none";
  result.where = choice == nullptr || choice->module->empty() ? mount.where : choice->module.where;
  if (module == "oracle") result.oracle.emplace();
  if (const auto maker = makers.find(module); maker != makers.end()) result.settings.maker = maker->second;
  if (choice != nullptr) {
    if (*choice->period > 0) period = *choice->period, period_where = choice->period.where;
    if (choice->phase.given()) phase = *choice->phase;
    if (result.oracle) {
      readSightErrors(*choice, result.oracle->errors, diagnostics);
    } else {
      readPictures(*choice, result.settings, diagnostics);
    }
  }
  if (result.oracle) result.oracle->period = period, result.oracle->phase = phase;
  if (result.on && !(period >= control_period)) {
    diagnostics.error(period_where, fmt::format("{}: period of camera {} is {} s, expected at least the control "
                                                "software's of {} s",
                                                robot.path(), mount.name, period, control_period));
  }
  return result;
}

void reportUnknownCameras(const RobotSettings& robot, const RobotModel& model, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const CameraMount& mount : model.cameras) known.push_back(mount.name);
  for (const ModuleChoice& choice : robot.cameras) {
    if (std::find(known.begin(), known.end(), choice.slot) != known.end()) continue;
    diagnostics.error(placeOf(choice, robot),
                      fmt::format("{} has no camera \"{}\"; it has {}{}", robot.path(), choice.slot,
                                  fmt::join(known, ", "), didYouMean(choice.slot, known)));
  }
}

}  // namespace murosimf
