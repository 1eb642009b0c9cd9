#include "murosimf/scene/module_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/error_choice.h"
#include "murosimf/scene/level_slots.h"

namespace murosimf {

namespace {

constexpr std::string_view kExtraModule = "modules.";

std::vector<std::string> slotNames(const LevelSlots& level) {
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

const LevelSlots& levelOf(const RobotSettings& robot, std::string_view motion) {
  return levelOfMotion(motion, *robot.level);
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

SourceLocation placeOf(const ModuleChoice& choice, const RobotSettings& robot) {
  if (choice.module.given()) return choice.module.where;
  if (choice.period.given()) return choice.period.where;
  if (choice.phase.given()) return choice.phase.where;
  return choice.parameters.empty() ? robot.where : choice.parameters.front().name_where;
}

WrittenValue writtenValue(const SceneValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return {{*number}, ""};
  if (const auto* truth = std::get_if<bool>(&value)) return {{*truth ? 1.0 : 0.0}, ""};
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return {*numbers, ""};
  if (const auto* text = std::get_if<std::string>(&value)) return {{}, *text};
  return {{}, fmt::format("{}", fmt::join(std::get<std::vector<std::string>>(value), " "))};
}

namespace {

/// Chooses the modules of one of a robot's levels of detail.
class LevelChoice {
 public:
  LevelChoice(const RobotSettings& robot, const MotionPlan& plan, int number, const ModuleRegistry& registry,
              Diagnostics& diagnostics)
      : robot_(robot),
        plan_(plan),
        registry_(registry),
        number_(number),
        motion_(plan.motions[static_cast<std::size_t>(number)]),
        level_(levelOf(robot, motion_)),
        diagnostics_(diagnostics) {}

  std::vector<Assignment> assignments() {
    for (const Slot& slot : level_.slots) fill(slot);
    for (const ModuleChoice& choice : robot_.modules) {
      if (!choice.slot.starts_with(kExtraModule)) continue;
      const std::string name = choice.module->empty() ? choice.slot.substr(kExtraModule.size()) : *choice.module;
      if (!needsAnotherLevel(name)) assign(name, &choice);
    }
    return std::move(assignments_);
  }

 private:
  /// What the scenario says of a slot; of the motion it speaks of the one that the robot starts with, and a module that
  /// belongs to another level of the plan is that one's.
  const ModuleChoice* choiceOf(std::string_view slot) const {
    const ModuleChoice* choice = slot == "motion" && number_ > 0 ? nullptr : choiceFor(robot_, slot);
    return choice != nullptr && isOfAnotherLevel(slot, *choice->module) ? nullptr : choice;
  }
  bool isOfAnotherLevel(std::string_view slot, std::string_view module) const {
    return slot != "motion" && !takes(level_, slot, module) &&
           anyLevel([&](const LevelSlots& level) { return takes(level, slot, module); });
  }
  bool needsAnotherLevel(std::string_view further) const {
    return !isFurther(level_, further) && anyLevel([&](const LevelSlots& level) { return isFurther(level, further); });
  }
  template <class Predicate>
  bool anyLevel(const Predicate& holds) const {
    return std::any_of(plan_.motions.begin(), plan_.motions.end(),
                       [&](const std::string& motion) { return holds(levelOf(robot_, motion)); });
  }
  std::string moduleFor(const Slot& slot) const {
    if (slot.name == "motion") return motion_;
    const ModuleChoice* choice = choiceOf(slot.name);
    return choice == nullptr || choice->module->empty() ? std::string(slot.module) : *choice->module;
  }
  /// The motion's period holds for all modules of the level that do not say otherwise: they follow it.
  double period() const {
    const ModuleChoice* motion = choiceOf("motion");
    return motion != nullptr && *motion->period > 0 ? *motion->period : level_.period;
  }
  void assign(std::string module, const ModuleChoice* choice) {
    assignments_.push_back(assignmentOf(std::move(module), choice, period(), robot_.where));
    assignments_.back().level = number_;
  }
  /// Where the module of a slot was chosen; nothing where the level brings it.
  const SourceLocation* whereChosen(const Slot& slot) const {
    const bool focused = slot.name == "motion" && robot_.focus && motion_ == *robot_.focus->motion;
    if (focused) return &robot_.focus->motion.where;
    const ModuleChoice* choice = choiceFor(robot_, slot.name);
    return choice == nullptr ? nullptr : &choice->module.where;
  }
  void fill(const Slot& slot) {
    const SourceLocation* place = whereChosen(slot);
    const std::string module = moduleFor(slot);
    if (module == "none") return;
    const ModuleEntry* entry = registry_.find(module);
    if (entry == nullptr && place != nullptr) {
      const std::vector<std::string> known = modulesFor(slot.name, registry_);
      diagnostics_.error(
          *place, fmt::format("{}: unknown module \"{}\" for {}; expected none or one of {}{}", robot_.path(), module,
                              slot.name, fmt::join(known, ", "), didYouMean(module, known)));
    } else if (entry != nullptr && entry->concern != slot.name) {
      diagnostics_.error(
          place == nullptr ? robot_.where : *place,
          fmt::format("{}: module {} is for {}, not for {}", robot_.path(), module, entry->concern, slot.name));
    } else {
      assign(module, choiceOf(slot.name));
    }
  }

  const RobotSettings& robot_;
  const MotionPlan& plan_;
  const ModuleRegistry& registry_;
  int number_;
  const std::string& motion_;
  const LevelSlots& level_;
  Diagnostics& diagnostics_;
  std::vector<Assignment> assignments_;
};

/// Slots that the scenario speaks of and that none of the robot's levels has.
void refuseUnknownSlots(const RobotSettings& robot, const MotionPlan& plan, Diagnostics& diagnostics) {
  std::vector<std::string> slots;
  for (const std::string& motion : plan.motions) {
    for (const std::string& name : slotNames(levelOf(robot, motion))) {
      if (std::find(slots.begin(), slots.end(), name) == slots.end()) slots.push_back(name);
    }
  }
  for (const ModuleChoice& choice : robot.modules) {
    refusePhase(robot, choice, diagnostics);
    const bool known =
        choice.slot.starts_with(kExtraModule) || std::find(slots.begin(), slots.end(), choice.slot) != slots.end();
    if (known) continue;
    diagnostics.error(placeOf(choice, robot),
                      fmt::format("{}: level \"{}\" has no {}; it has {}", robot.path(),
                                  levelOf(robot, plan.motions.front()).name, choice.slot, fmt::join(slots, ", ")));
  }
}

}  // namespace

namespace {

void addFocus(const RobotSettings& robot, MotionPlan& plan, Diagnostics& diagnostics) {
  if (!plan.changes.empty()) {
    diagnostics.error(robot.focus->where,
                      fmt::format("{}: focus chooses the motion by distances, and motion does by times; expected one "
                                  "of them",
                                  robot.path()));
  }
  if (*robot.focus->motion == plan.motions.front()) {
    diagnostics.error(robot.focus->motion.where, fmt::format("{}: focus has the robot's usual motion \"{}\"; expected "
                                                             "another one",
                                                             robot.path(), *robot.focus->motion));
  }
  plan.near_level = plan.levelWith(*robot.focus->motion);
}

}  // namespace

bool isOnWheels(const World& world, ObjectId robot) {
  return !world.members(robot, subset::kWheels).empty() && world.members(robot, subset::kSoles).empty();
}

MotionPlan motionPlanOf(const RobotSettings& robot, Diagnostics& diagnostics, bool on_wheels) {
  const std::string usual(levelNamed(*robot.level, on_wheels).motion);
  const ModuleChoice* choice = choiceFor(robot, "motion");
  MotionPlan plan =
      readMotionPlan(choice == nullptr ? Located<std::string>{} : choice->module, usual, robot.path(), diagnostics);
  if (robot.focus) addFocus(robot, plan, diagnostics);
  return plan;
}

std::vector<Assignment> modulesOf(const RobotSettings& robot, const MotionPlan& plan, const ModuleRegistry& registry,
                                  Diagnostics& diagnostics) {
  std::vector<Assignment> all;
  for (std::size_t i = 0; i < plan.motions.size(); ++i) {
    LevelChoice level(robot, plan, static_cast<int>(i), registry, diagnostics);
    for (Assignment& assignment : level.assignments()) all.push_back(std::move(assignment));
  }
  refuseUnknownSlots(robot, plan, diagnostics);
  dropErrorsWithoutSensor(all, registry);
  return all;
}

}  // namespace murosimf
