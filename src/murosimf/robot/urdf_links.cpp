#include "murosimf/robot/urdf_links.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/robot/checks.h"

namespace murosimf::urdf {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class Connector {
 public:
  Connector(const RobotPart& robot, Diagnostics& diagnostics) : robot_(robot), diagnostics_(diagnostics) {
    for (std::size_t i = 0; i < robot.links.size(); ++i) links_.emplace(robot.links[i].body.name, static_cast<int>(i));
    graph_.joints_below.resize(robot.links.size());
    graph_.joint_above.assign(robot.links.size(), -1);
  }

  LinkGraph run() {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) connect(static_cast<int>(j));
    std::vector<int> roots;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (graph_.joint_above[i] < 0) roots.push_back(static_cast<int>(i));
    }
    reached_.assign(robot_.links.size(), 0);
    chooseRoot(roots);
    reportCycles();
    return std::move(graph_);
  }

 private:
  int find(const Reference& link) {
    const auto found = links_.find(link.name);
    if (found != links_.end()) return found->second;
    if (!link.name.empty()) {
      diagnostics_.error(link.where,
                         "link " + quoted(link.name) + " does not exist" + nearestKey(diagnostics_, link.name, links_));
    }
    return -1;
  }

  void connect(int j) {
    const JointPart& part = robot_.joints[at(j)];
    const int parent = find(part.parent), child = find(part.child);
    graph_.child_of_joint.push_back(child);
    if (parent < 0 || child < 0) {
      if (child >= 0 && graph_.joint_above[at(child)] < 0) graph_.joint_above[at(child)] = j;  // its mistake is told
      return;
    }
    if (const int other = graph_.joint_above[at(child)]; other >= 0) {
      const Joint& first = robot_.joints[at(other)].joint;
      return diagnostics_.error(part.child.where, "link " + quoted(part.child.name) + " is the child of joint " +
                                                      quoted(part.joint.name) + " and of joint " + quoted(first.name) +
                                                      fmt::format(" in line {}, expected one", first.where.line));
    }
    graph_.joint_above[at(child)] = j;
    graph_.joints_below[at(parent)].push_back(j);
  }

  /// Marks all links below this one; returns how many.
  int reach(int root, char mark) {
    int count = 0;
    std::vector<int> open{root};
    while (!open.empty()) {
      const int link = open.back();
      open.pop_back();
      if (std::exchange(reached_[at(link)], mark) != 0) continue;
      ++count;
      for (const int joint : graph_.joints_below[at(link)]) open.push_back(graph_.child_of_joint[at(joint)]);
    }
    return count;
  }

  /// The robot is what hangs on the root with the most links; the other roots are not connected to it.
  void chooseRoot(const std::vector<int>& roots) {
    int most = 0;
    for (const int root : roots) {
      const int count = reach(root, 1);
      if (count > most) most = count, graph_.root = root;
    }
    for (const int root : roots) {
      if (root == graph_.root) continue;
      const Body& lost = robot_.links[at(root)].body;
      diagnostics_.error(lost.where,
                         "link " + quoted(lost.name) + " is not connected: no joint has it as its child, and " +
                             "the robot has the root " + quoted(robot_.links[at(graph_.root)].body.name) + " already");
    }
  }

  /// Links below no root hang on a circle of joints. One error for each circle.
  void reportCycles() {
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (reached_[i] != 0) continue;
      std::vector<char> on_way(robot_.links.size(), 0);
      int link = static_cast<int>(i);
      while (link >= 0 && reached_[at(link)] == 0 && on_way[at(link)] == 0) {
        on_way[at(link)] = 1;
        link = parentOf(link);
      }
      if (link >= 0 && reached_[at(link)] == 0) reportCycle(link);
      for (std::size_t k = 0; k < on_way.size(); ++k) reached_[k] = static_cast<char>(reached_[k] | on_way[k]);
    }
  }

  void reportCycle(int start) {
    std::string names;
    const Joint* first = nullptr;
    int link = start, count = 0;
    do {
      const Joint& joint = robot_.joints[at(graph_.joint_above[at(link)])].joint;
      if (++count <= 8) names = quoted(joint.name) + (names.empty() ? "" : ", ") + names;
      if (first == nullptr || joint.where.line < first->where.line) first = &joint;
      link = parentOf(link);
    } while (link != start);
    diagnostics_.error(first->where,
                       "joints form a cycle: " + names + (count > 8 ? ", ..." : "") + "; expected a tree");
  }

  int parentOf(int link) const {
    const int joint = graph_.joint_above[at(link)];
    if (joint < 0) return -1;
    const auto parent = links_.find(robot_.joints[at(joint)].parent.name);
    return parent == links_.end() ? -1 : parent->second;
  }

  const RobotPart& robot_;
  Diagnostics& diagnostics_;
  std::map<std::string, int> links_;
  std::vector<char> reached_;
  LinkGraph graph_;
};

}  // namespace

LinkGraph connectLinks(const RobotPart& robot, Diagnostics& diagnostics) { return Connector(robot, diagnostics).run(); }

void checkNames(const RobotPart& robot, Diagnostics& diagnostics) {
  std::map<std::string, int> lines;
  const auto claim = [&](const char* what, const std::string& name, const SourceLocation& where) {
    const auto [first, added] = lines.emplace(name, where.line);
    if (added || name.empty()) return;
    diagnostics.error(where, std::string(what) + " " + quoted(name) +
                                 fmt::format(": the name is used in line {} already", first->second));
  };
  for (const LinkPart& link : robot.links) {
    claim("link", link.body.name, link.body.where);
    for (const Sole& sole : link.soles) claim("sole", sole.name, sole.where);
    for (const CameraPart& camera : link.cameras) claim("camera", camera.mount.name, camera.mount.where);
    for (const ImuMount& imu : link.imus) claim("imu", imu.name, imu.where);
    for (const PressureSensorMount& s : link.pressure_sensors) claim("pressure_sensor", s.name, s.where);
    for (const TouchSensorMount& s : link.touch_sensors) claim("touch_sensor", s.name, s.where);
    for (const ForceSensorMount& s : link.force_sensors) claim("force_sensor", s.name, s.where);
    for (const RangeSensorPart& s : link.range_sensors) claim("range sensor", s.mount.name, s.mount.where);
    for (const WheelMount& wheel : link.wheels) claim("wheel", wheel.name, wheel.where);
  }
  for (const JointPart& part : robot.joints) claim("joint", part.joint.name, part.joint.where);
}

}  // namespace murosimf::urdf
