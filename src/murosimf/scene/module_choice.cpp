#include "murosimf/scene/module_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace murosimf {

namespace {

/// One slot of a level of detail and the module that fills it when nobody chooses another.
struct Slot {
  std::string_view name, module;
};
constexpr Slot kKinematicSlots[] = {{"actuation", "ideal_servo"},
                                    {"motion", "kinematic_walking"},
                                    {"kinematics", "body_poses"},
                                    {"sensing", "inertial_sensor"}};
constexpr Slot kMultibodySlots[] = {
    {"electronics", "servo_controller"},  {"velocities", "tree_motion"},     {"actuation", "position_servo"},
    {"contact", "hunt_crossley_contact"}, {"motion", "multibody_dynamics"},  {"sensing", "dynamic_inertial_sensor"},
    {"pressure", "foot_pressure"},        {"integration", "implicit_euler"}, {"kinematics", "body_poses"}};
/// A level of detail: a motion module, and the modules that go with it.
struct Level {
  std::string_view name, motion;
  std::span<const Slot> slots;
  double period;  ///< [s]; 0: every frame
};
constexpr Level kLevels[] = {{"kinematic", "kinematic_walking", kKinematicSlots, 0.01},
                             {"full", "multibody_dynamics", kMultibodySlots, 0}};
constexpr std::string_view kExtraModule = "modules.";

std::vector<std::string> slotNames(const Level& level) {
  std::vector<std::string> names;
  for (const Slot& slot : level.slots) names.emplace_back(slot.name);
  return names;
}

std::vector<std::string> modulesFor(std::string_view slot, const ModuleRegistry& registry) {
  std::vector<std::string> names;
  for (const ModuleEntry& entry : registry.entries()) {
    if (entry.concern == slot) names.emplace_back(entry.name);
  }
  return names;
}

const ModuleChoice* choiceFor(const RobotSettings& robot, std::string_view slot) {
  const auto found = std::find_if(robot.modules.begin(), robot.modules.end(),
                                  [&](const ModuleChoice& choice) { return choice.slot == slot; });
  return found == robot.modules.end() ? nullptr : &*found;
}

/// Where a choice was written: its module, or else the first thing that was said of it.
SourceLocation placeOf(const ModuleChoice& choice, const RobotSettings& robot) {
  if (choice.module.given()) return choice.module.where;
  if (choice.period.given()) return choice.period.where;
  if (choice.phase.given()) return choice.phase.where;
  return choice.parameters.empty() ? robot.where : choice.parameters.front().name_where;
}

/// The level that the robot has by name, or that of the motion module that was chosen for it: what a motion needs
/// beside it comes with it.
const Level& levelOf(const RobotSettings& robot) {
  const ModuleChoice* motion = choiceFor(robot, "motion");
  const Level* found = &kLevels[0];
  for (const Level& level : kLevels) {
    if (level.name == *robot.level) found = &level;
  }
  for (const Level& level : kLevels) {
    if (motion != nullptr && level.motion == *motion->module) found = &level;
  }
  return *found;
}

/// The motion's period holds for all modules of the robot that do not say otherwise: they follow it.
double motionPeriod(const RobotSettings& robot, const Level& level) {
  const ModuleChoice* motion = choiceFor(robot, "motion");
  return motion != nullptr && *motion->period > 0 ? *motion->period : level.period;
}

Assignment assignmentOf(std::string module, const ModuleChoice* choice, double period, const SourceLocation& where) {
  Assignment assignment{{}, std::move(module), {}, where};
  assignment.parameters.emplace("period", WrittenParameter{{{period}, ""}, where});
  if (choice == nullptr) return assignment;
  if (choice->module.given()) assignment.where = choice->module.where;
  if (*choice->period > 0) {
    assignment.parameters.insert_or_assign("period", WrittenParameter{{{*choice->period}, ""}, choice->period.where});
  }
  // Modules step in phase; the linker says so to who asks for another one.
  if (choice->phase.given()) {
    assignment.parameters.insert_or_assign("phase", WrittenParameter{{{*choice->phase}, ""}, choice->phase.where});
  }
  for (const NamedValue& parameter : choice->parameters) {
    assignment.parameters.insert_or_assign(parameter.name,
                                           WrittenParameter{writtenValue(*parameter.value), parameter.name_where});
  }
  return assignment;
}

void refusePhase(const RobotSettings& robot, const ModuleChoice& choice, Diagnostics& diagnostics) {
  if (*choice.phase == 0) return;
  diagnostics.error(choice.phase.where, fmt::format("{}: phase of {} is {} s; expected 0: modules begin with the first "
                                                    "frame, cameras alone can begin later",
                                                    robot.path(), choice.slot, *choice.phase));
}

}  // namespace

WrittenValue writtenValue(const SceneValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return {{*number}, ""};
  if (const auto* truth = std::get_if<bool>(&value)) return {{*truth ? 1.0 : 0.0}, ""};
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return {*numbers, ""};
  if (const auto* text = std::get_if<std::string>(&value)) return {{}, *text};
  return {{}, fmt::format("{}", fmt::join(std::get<std::vector<std::string>>(value), " "))};
}

std::vector<Assignment> modulesOf(const RobotSettings& robot, const ModuleRegistry& registry,
                                  Diagnostics& diagnostics) {
  std::vector<Assignment> assignments;
  const Level& level = levelOf(robot);
  const std::vector<std::string> slots = slotNames(level);
  const double period = motionPeriod(robot, level);
  for (const Slot& slot : level.slots) {
    const ModuleChoice* choice = choiceFor(robot, slot.name);
    const std::string module =
        choice == nullptr || choice->module->empty() ? std::string(slot.module) : *choice->module;
    if (module == "none") continue;
    const ModuleEntry* entry = registry.find(module);
    if (entry == nullptr && choice != nullptr) {
      const std::vector<std::string> known = modulesFor(slot.name, registry);
      diagnostics.error(choice->module.where,
                        fmt::format("{}: unknown module \"{}\" for {}; expected none or one of {}{}", robot.path(),
                                    module, slot.name, fmt::join(known, ", "), didYouMean(module, known)));
      continue;
    }
    if (entry != nullptr && entry->concern != slot.name) {
      diagnostics.error(choice->module.where, fmt::format("{}: module {} is for {}, not for {}", robot.path(), module,
                                                          entry->concern, slot.name));
      continue;
    }
    assignments.push_back(assignmentOf(module, choice, period, robot.where));
  }
  for (const ModuleChoice& choice : robot.modules) {
    refusePhase(robot, choice, diagnostics);
    if (choice.slot.starts_with(kExtraModule)) {
      const std::string name = choice.module->empty() ? choice.slot.substr(kExtraModule.size()) : *choice.module;
      assignments.push_back(assignmentOf(name, &choice, period, robot.where));
    } else if (std::find(slots.begin(), slots.end(), choice.slot) == slots.end()) {
      diagnostics.error(placeOf(choice, robot), fmt::format("{}: level \"{}\" has no {}; it has {}", robot.path(),
                                                            level.name, choice.slot, fmt::join(slots, ", ")));
    }
  }
  return assignments;
}

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
      if (parameter.name == "noise") {
        readNumber(parameter, 0, 0.5, result.settings.noise, diagnostics);
      } else if (parameter.name == "gain") {
        readNumber(parameter, 0.01, 100, result.settings.gain, diagnostics);
      } else if (parameter.name == "antialias") {
        readSwitch(parameter, result.settings.antialias, diagnostics);
      } else {
        diagnostics.error(parameter.name_where,
                          fmt::format("module ray_caster has no parameter \"{}\"; it knows noise, "
                                      "gain, antialias{}",
                                      parameter.name, didYouMean(parameter.name, {"noise", "gain", "antialias"})));
      }
    }
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
