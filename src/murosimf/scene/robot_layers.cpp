#include "murosimf/scene/robot_layers.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "murosimf/scene/table_reader.h"

namespace murosimf {

namespace {

/// `motion = "walk"` says the same as `motion = {module = "walk"}`.
void nameToTable(TextNode* choice, std::string_view name_key) {
  if (choice == nullptr || choice->kind != TextNode::Kind::kText) return;
  TextNode name = std::exchange(*choice, TextNode{});
  choice->key = std::exchange(name.key, std::string(name_key));
  choice->key_where = name.key_where;
  choice->where = name.where;
  name.key_where = name.where;
  choice->children.push_back(std::move(name));
}

void namesToTables(TextNode* choices) {
  if (choices == nullptr || !choices->isTable()) return;
  for (TextNode& choice : choices->children) nameToTable(&choice, "module");
}

void poseToTable(TextNode* pose) {
  if (pose == nullptr || pose->kind != TextNode::Kind::kArray || pose->children.size() != 3) return;
  pose->kind = TextNode::Kind::kTable;
  const char* const names[] = {"x", "y", "heading"};
  for (std::size_t i = 0; i < 3; ++i) {
    pose->children[i].key = names[i];
    pose->children[i].key_where = pose->children[i].where;
  }
}

/// Collects the values below a table under their dotted names; of one named twice, the later stays.
void flatten(TextNode& node, const std::string& name, std::vector<TextNode>& out) {
  if (node.isTable() && !looksLikeAngle(node)) {
    for (TextNode& child : node.children) flatten(child, name.empty() ? child.key : name + "." + child.key, out);
    return;
  }
  std::erase_if(out, [&](const TextNode& n) { return n.key == name; });
  node.key = name;
  out.push_back(std::move(node));
}

void normaliseRobot(TextNode& robot) {
  if (!robot.isTable()) return;
  for (const std::string_view slot : kModuleSlots) nameToTable(robot.find(slot), "module");
  for (const std::string_view table : {"control", "focus", "localisation"})
    nameToTable(robot.find(table), nameKeyOf(table));
  namesToTables(robot.find("cameras"));
  namesToTables(robot.find("modules"));
  for (const char* pose : {"pose", "kickoff_own", "kickoff_other"}) poseToTable(robot.find(pose));
  if (TextNode* properties = robot.find("properties"); properties != nullptr && properties->isTable()) {
    std::vector<TextNode> flat;
    flatten(*properties, "", flat);
    properties->children = std::move(flat);
  }
}

const TextNode* findPath(const TextNode& root, std::initializer_list<std::string_view> path) {
  const TextNode* at = &root;
  for (const std::string_view part : path)
    if (at != nullptr) at = at->find(part);
  return at;
}

/// layOver for a module's table.
void layModule(TextNode& lower, const TextNode& upper) {
  const std::string_view name_key = nameKeyOf(lower.key);
  const TextNode* below = lower.find(name_key);
  const TextNode* above = upper.find(name_key);
  const bool other = above != nullptr && (below == nullptr || below->scalar != above->scalar);
  if (other)
    lower = upper;
  else
    layOver(lower, upper);
}

void layModules(TextNode& lower, const TextNode& upper) {
  if (!lower.isTable() || !upper.isTable()) {
    lower = upper;
    return;
  }
  for (const TextNode& child : upper.children) {
    if (TextNode* below = lower.find(child.key))
      layModule(*below, child);
    else
      lower.children.push_back(child);
  }
}

bool isModuleSlot(std::string_view key) {
  return key == "control" || key == "localisation" ||
         std::find(std::begin(kModuleSlots), std::end(kModuleSlots), key) != std::end(kModuleSlots);
}

void layRobot(TextNode& lower, const TextNode* upper) {
  if (upper == nullptr || !upper->isTable()) return;
  for (const TextNode& child : upper->children) {
    TextNode* below = lower.find(child.key);
    if (below == nullptr)
      lower.children.push_back(child);
    else if (isModuleSlot(child.key))
      layModule(*below, child);
    else if (child.key == "cameras" || child.key == "modules")
      layModules(*below, child);
    else
      layOver(*below, child);
  }
}

}  // namespace

std::string_view nameKeyOf(std::string_view table) {
  if (table == "control") return "program";
  return table == "focus" ? "motion" : "module";
}

void normaliseRobotTables(TextNode& scenario) {
  if (TextNode* teams = scenario.find("teams"))
    for (TextNode& team : teams->children) normaliseRobot(team);
  TextNode* robots = scenario.find("robots");
  if (robots == nullptr) return;
  for (TextNode& team : robots->children) {
    if (team.key == "all")
      normaliseRobot(team);
    else
      for (TextNode& robot : team.children) normaliseRobot(robot);
  }
}

TextNode layeredRobot(const TextNode& scenario, const TextNode& changes, std::string_view team,
                      std::string_view number) {
  TextNode out;
  if (const TextNode* own = findPath(scenario, {"robots", team, number})) {
    out.key = own->key;
    out.key_where = own->key_where;
    out.where = own->where;
  }
  for (const TextNode* tree : {&scenario, &changes}) {
    layRobot(out, findPath(*tree, {"robots", "all"}));
    layRobot(out, findPath(*tree, {"teams", team}));
    layRobot(out, findPath(*tree, {"robots", team, number}));
  }
  std::erase_if(out.children, [](const TextNode& child) { return child.key == "attacks"; });
  return out;
}

}  // namespace murosimf
