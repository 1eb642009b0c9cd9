#include "murosimf/scene/camera_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/module_choice.h"
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

}  // namespace

CameraChoice cameraChoice(const RobotSettings& robot, const CameraMount& mount, double control_period,
                          Diagnostics& diagnostics) {
  CameraChoice result;
  SourceLocation period_where = mount.where;
  result.settings.period = mount.period;
  result.settings.phase = mount.phase;
  for (const ModuleChoice& choice : robot.cameras) {
    if (choice.slot != mount.name) continue;
    if (*choice.module == "none") result.on = false;
    if (!choice.module->empty() && *choice.module != "none" && *choice.module != "ray_caster") {
      diagnostics.error(choice.module.where,
                        fmt::format("{}: unknown camera module \"{}\"; expected none or ray_caster{}", robot.path(),
                                    *choice.module, didYouMean(*choice.module, {"none", "ray_caster"})));
    }
    if (*choice.period > 0) result.settings.period = *choice.period, period_where = choice.period.where;
    if (choice.phase.given()) result.settings.phase = *choice.phase;
    for (const NamedValue& parameter : choice.parameters) {
      if (PictureChainReader::owns(parameter)) continue;
      if (parameter.name == "noise") {
        readNumber(parameter, 0, 0.5, result.settings.noise, diagnostics);
      } else if (parameter.name == "gain") {
        readNumber(parameter, 0.01, 100, result.settings.gain, diagnostics);
      } else if (parameter.name == "antialias") {
        readSwitch(parameter, result.settings.antialias, diagnostics);
      } else if (parameter.name == "shadows") {
        readSwitch(parameter, result.settings.shadows, diagnostics);
      } else if (parameter.name != "lens" && parameter.name != "extrapolate") {  // these are read by LensBuilder
        std::vector<std::string> known{"noise", "gain", "antialias", "shadows", "lens", "extrapolate"};
        for (std::string& name : PictureChainReader::knownParameters()) known.push_back(std::move(name));
        diagnostics.error(parameter.name_where,
                          fmt::format("module ray_caster has no parameter \"{}\"; it knows {}{}", parameter.name,
                                      fmt::join(known, ", "), didYouMean(parameter.name, known)));
      }
    }
    PictureChainReader(choice, diagnostics).read(result.settings);
  }
  if (result.on && !(result.settings.period >= control_period)) {
    diagnostics.error(period_where, fmt::format("{}: period of camera {} is {} s, expected at least the control "
                                                "software's of {} s",
                                                robot.path(), mount.name, result.settings.period, control_period));
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
