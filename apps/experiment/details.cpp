#include "experiment/details.h"

#include <algorithm>

#include "murosimf/robot/urdf_reader.h"

namespace murosimf {

namespace {

const ModuleChoice* find(const std::vector<ModuleChoice>& list, std::string_view slot) {
  const auto at = std::find_if(list.begin(), list.end(), [&](const ModuleChoice& c) { return c.slot == slot; });
  return at == list.end() ? nullptr : &*at;
}

bool isOn(const ModuleChoice* choice, std::string_view parameter) {
  if (choice == nullptr) return false;
  return std::any_of(choice->parameters.begin(), choice->parameters.end(),
                     [&](const NamedValue& p) { return p.name == parameter && p.value.value == SceneValue(true); });
}

class DetailFinder {
 public:
  DetailFinder(const std::vector<std::string>& fixed, const std::vector<std::string>& only, Diagnostics& diagnostics)
      : only_(only), diagnostics_(diagnostics) {
    for (const std::string& assignment : fixed) fixed_.push_back(assignment.substr(0, assignment.find('=')));
  }

  std::vector<Detail> find(const Scene& scene) {
    for (const RobotSettings& robot : scene.robots) addRobot(robot);
    return std::move(details_);
  }

 private:
  void addRobot(const RobotSettings& robot) {
    const std::string path = robot.path() + ".";
    const ModuleChoice* motion = murosimf::find(robot.modules, "motion");
    if (motion == nullptr || motion->module->empty()) add(robot, path + "level", {"full", "fast", "kinematic"});
    addCameras(robot);
    const bool thinks = !robot.control.module->empty() && *robot.control.module != "none";
    if (thinks && robot.localisation.module->empty()) add(robot, path + "localisation", {"none", "oracle"});
    const ModuleChoice* collision = murosimf::find(robot.modules, "collision");
    const std::string shapes = collision == nullptr || collision->module->empty() ? "primitives" : *collision->module;
    if (shapes != "feet_only") add(robot, path + "collision", {shapes, "feet_only"});
    for (const ModuleChoice& further : robot.modules)
      if (further.slot.starts_with("modules.") && *further.module != "none")
        add(robot, path + further.slot, {*further.module, "none"});
  }

  void addCameras(const RobotSettings& robot) {
    const ReadResult model = readUrdf(robot.file_found.string(), diagnostics_);
    if (!model) return;
    for (const CameraMount& camera : model->cameras) {
      const ModuleChoice* choice = murosimf::find(robot.cameras, camera.name);
      const std::string module = choice == nullptr ? "" : *choice->module;
      if (module == "none") continue;
      const std::string path = robot.path() + ".cameras." + camera.name;
      const std::size_t place = details_.size();
      const std::string maker = module.empty() || module == "oracle" ? "ray_caster" : module;
      if (!add(robot, path, {maker, "oracle", "none"})) continue;
      for (const char* effect : {"shadows", "antialias"})
        if (isOn(choice, effect) && add(robot, path + "." + effect, {"true", "false"})) details_.back().within = place;
    }
  }

  bool isAsked(const std::string& path) const {
    return only_.empty() || std::any_of(only_.begin(), only_.end(), [&](const std::string& beginning) {
             return path == beginning || path.starts_with(beginning + ".");
           });
  }

  /// @return false where it was not asked for, or where the user has fixed it, for this robot, its team or all
  bool add(const RobotSettings& robot, const std::string& path, std::vector<std::string> choices) {
    const std::string rest = path.substr(robot.path().size());
    const auto names = [&](const std::string& key) {
      // One inside the other either way: a detail's choice would take parameters away that the user has set.
      const auto isOrHolds = [&](const std::string& own) {
        return own == key || own.starts_with(key + ".") || key.starts_with(own + ".");
      };
      return isOrHolds(path) || isOrHolds("robots.all" + rest) || isOrHolds("teams." + robot.team + rest);
    };
    if (!isAsked(path) || std::any_of(fixed_.begin(), fixed_.end(), names)) return false;
    details_.push_back({path, std::move(choices), std::nullopt});
    return true;
  }

  std::vector<std::string> fixed_;  // paths
  const std::vector<std::string>& only_;
  Diagnostics& diagnostics_;
  std::vector<Detail> details_;
};

}  // namespace

bool isMeant(const std::vector<Detail>& details, const Choices& choices, std::size_t detail) {
  const std::optional<std::size_t>& within = details[detail].within;
  return !within || choices[*within] == 0;
}

std::vector<std::string> overridesOf(const std::vector<Detail>& details, const Choices& choices) {
  std::vector<std::string> overrides;
  for (std::size_t d = 0; d < details.size(); ++d)
    if (isMeant(details, choices, d)) overrides.push_back(details[d].path + "=" + details[d].choices[choices[d]]);
  return overrides;
}

std::vector<Detail> detailsOf(const Scene& scene, const std::vector<std::string>& fixed,
                              const std::vector<std::string>& only, Diagnostics& diagnostics) {
  return DetailFinder(fixed, only, diagnostics).find(scene);
}

}  // namespace murosimf
