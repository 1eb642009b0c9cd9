#include "murosimf/scene/robot_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "murosimf/scene/robot_layers.h"
#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSection = "robots.TEAM.NUMBER";

/// Reads all robot tables' parts with one set of diagnostics.
class RobotReader {
 public:
  RobotReader(const TextNode& table, RobotTable kind, std::string_view name, const fs::path& scenario,
              Diagnostics& diagnostics)
      : table_(table),
        reader_(&table, kSection, diagnostics, name),
        kind_(kind),
        scenario_(scenario),
        problems_(diagnostics) {}

  RobotSettings read(std::vector<std::string> more) {
    reader_.refuseUnknownKeys(more);
    RobotSettings robot;
    robot.where = table_.key_where;
    readFile(robot);
    readPoses(robot);
    reader_.read("role", robot.role);
    reader_.read("level", robot.level);
    for (const std::string_view slot : kModuleSlots)
      if (const TextNode* node = reader_.child(slot)) addModule(robot.modules, std::string(slot), *node);
    readNamedModules("modules", "modules.", robot.modules);
    readNamedModules("cameras", "", robot.cameras);
    robot.localisation.slot = "localisation";
    if (const TextNode* node = reader_.child("localisation")) readChoice(robot.localisation, *node, "MODULE", "module");
    readFocus(robot);
    readControl(robot);
    readProperties(robot);
    return robot;
  }

 private:
  bool isRobot() const { return kind_ == RobotTable::kRobot; }

  void readFile(RobotSettings& robot) {
    if (!reader_.read("file", robot.file)) {
      if (isRobot() && reader_.child("file") == nullptr)
        problems_.error(table_.key_where,
                        "file is missing, expected the robot's file, as in file = \"robots/ks21.urdf\"");
      return;
    }
    robot.file_found = findDataFile(*robot.file, scenario_);
    if (robot.file_found.empty())
      problems_.error(robot.file.where, "there is no robot file " + whereLooked(*robot.file, scenario_));
  }

  void readPoses(RobotSettings& robot) {
    if (!isRobot()) return refusePoses();
    if (!reader_.read("pose", robot.pose) && reader_.child("pose") == nullptr)
      problems_.error(table_.key_where, "pose is missing, expected pose = [x, y, heading] in the field's frame");
    Located<PlanarPose> pose;
    if (reader_.read("kickoff_own", pose)) robot.kickoff_own = pose;
    if (reader_.read("kickoff_other", pose)) robot.kickoff_other = pose;
  }

  void refusePoses() {
    for (const char* key : {"pose", "kickoff_own", "kickoff_other"})
      if (const TextNode* node = reader_.child(key))
        problems_.error(node->key_where, fmt::format("{} stands among the defaults of many robots, expected in a "
                                                     "table of one robot, as [robots.red.1]",
                                                     key));
  }

  /// @return false when the node is no choice of a module
  bool readChoice(ModuleChoice& choice, const TextNode& node, std::string_view section, const char* name_key) {
    if (!node.isTable()) {
      problems_.error(node.where, fmt::format("{} is {}, expected a name in quotes or a table", printable(node.key),
                                              describe(node)));
      return false;
    }
    const TableReader reader(&node, section, problems_);
    reader.read(name_key, choice.module);
    if (choice.module.given() && choice.module->empty())
      problems_.error(choice.module.where, fmt::format("{} is empty, expected a name", name_key));
    reader.read("period", choice.period);
    if (section == "MODULE") reader.read("phase", choice.phase);
    for (const TextNode& child : node.children) {
      if (child.key == name_key || child.key == "period" || child.key == "phase") continue;
      if (auto value = readSceneValue(child, printable(child.key), problems_))
        choice.parameters.push_back({child.key, child.key_where, std::move(*value)});
    }
    sortByName(choice.parameters);
    return true;
  }

  static void sortByName(std::vector<NamedValue>& values) {
    std::sort(values.begin(), values.end(), [](const NamedValue& a, const NamedValue& b) { return a.name < b.name; });
  }

  void addModule(std::vector<ModuleChoice>& list, std::string slot, const TextNode& node) {
    ModuleChoice choice;
    choice.slot = std::move(slot);
    if (readChoice(choice, node, "MODULE", "module")) list.push_back(std::move(choice));
  }

  void readNamedModules(std::string_view key, const std::string& prefix, std::vector<ModuleChoice>& list) {
    const TextNode* table = reader_.child(key);
    if (table == nullptr) return;
    if (!table->isTable()) {
      problems_.error(table->where, fmt::format("{} is {}, expected a table of names", key, describe(*table)));
      return;
    }
    const std::size_t first = list.size();
    for (const TextNode& node : table->children) {
      addModule(list, prefix + node.key, node);
      const bool named = list.empty() || list.back().module.given() || prefix.empty();
      if (!named) list.back().module = {node.key, node.key_where};
    }
    std::sort(list.begin() + static_cast<std::ptrdiff_t>(first), list.end(),
              [](const ModuleChoice& a, const ModuleChoice& b) { return a.slot < b.slot; });
  }

  void readFocus(RobotSettings& robot) {
    const TextNode* node = reader_.child("focus");
    if (node == nullptr) return;
    if (!node->isTable()) {
      problems_.error(node->where, fmt::format("focus is {}, expected a motion in quotes or a table", describe(*node)));
      return;
    }
    const TableReader reader(node, "FOCUS", problems_);
    reader.refuseUnknownKeys();
    FocusSettings focus;
    focus.where = node->key_where;
    reader.read("motion", focus.motion);
    reader.read("ball", focus.ball);
    reader.read("robots", focus.robots);
    reader.read("margin", focus.margin);
    if (*focus.motion != "none") robot.focus = focus;
  }

  void readControl(RobotSettings& robot) {
    robot.control.slot = "control";
    robot.control.module.value = "none";
    const TextNode* node = reader_.child("control");
    if (node == nullptr) return;
    if (const TextNode* phase = node->find("phase"))
      problems_.error(phase->key_where,
                      "unknown key \"phase\" in control, expected period or delay: all control "
                      "software takes its first step a period after the start");
    if (!readChoice(robot.control, *node, "CONTROL", "program")) return;
    readDelay(robot, *node);
    if (isRobot() && node->find("program") == nullptr)
      problems_.error(node->where, "control names no program, expected program = \"player\" or \"none\"");
  }

  /// The delay of control is ours, not a parameter of its program.
  void readDelay(RobotSettings& robot, const TextNode& node) {
    TableReader(&node, "CONTROL", problems_).read("delay", robot.control_delay);
    std::erase_if(robot.control.parameters, [](const NamedValue& value) { return value.name == "delay"; });
  }

  void readProperties(RobotSettings& robot) {
    const TextNode* table = reader_.child("properties");
    if (table == nullptr) return;
    if (!table->isTable()) {
      problems_.error(table->where, fmt::format("properties is {}, expected a table", describe(*table)));
      return;
    }
    for (const TextNode& child : table->children)
      if (auto value = readSceneValue(child, printable(child.key), problems_))
        robot.properties.push_back({child.key, child.key_where, std::move(*value)});
    sortByName(robot.properties);
  }

  const TextNode& table_;
  TableReader reader_;
  RobotTable kind_;
  const fs::path& scenario_;
  Diagnostics& problems_;
};

}  // namespace

RobotSettings readRobot(const TextNode& table, RobotTable kind, std::string_view name, const fs::path& scenario,
                        const std::vector<std::string>& more, Diagnostics& diagnostics) {
  return RobotReader(table, kind, name, scenario, diagnostics).read(more);
}

}  // namespace murosimf
