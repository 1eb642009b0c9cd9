#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "murosimf/robot/checks.h"
#include "murosimf/robot/tree_builder.h"
#include "murosimf/robot/urdf_links.h"

namespace murosimf::urdf {
namespace {

constexpr std::size_t kMostLinks = 1000;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Turns parts that have been checked into the model, from the root outwards, joints in the order of the file.
class Assembler {
 public:
  Assembler(const RobotPart& robot, const LinkGraph& graph, Diagnostics& diagnostics)
      : robot_(robot), graph_(graph), diagnostics_(diagnostics) {}

  RobotModel run() {
    model_.name = robot_.name;
    model_.where = robot_.where;
    buildTree();
    addJointSensors();
    resolveCameras();
    resolveIgnoredPairs();
    resolveProperties();
    resolveDevices(robot_, model_, diagnostics_);
    return std::move(model_);
  }

 private:
  /// A joint that waits to be built on this place.
  struct Open {
    TreePlace place;
    int joint;
  };

  /// What they measure passes through the joint that moves their link.
  void refuseForceSensors(int link, const std::string& reason) {
    for (const ForceSensorMount& sensor : robot_.links[at(link)].force_sensors) {
      diagnostics_.error(sensor.where, "force_sensor " + quoted(sensor.name) + " stands in a link that " + reason +
                                           ", expected one that a joint moves");
    }
  }

  void buildTree() {
    TreeBuilder builder;
    std::vector<Open> open;
    refuseForceSensors(graph_.root, "carries the others");
    checkWheels(robot_.links[at(graph_.root)], nullptr, diagnostics_);
    addLink(builder.base(robot_.links[at(graph_.root)].body.name), graph_.root, open, kAxisZ);
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const JointPart& part = robot_.joints[at(next.joint)];
      TreePlace place = next.place.pose(part.X_PJ);
      if (!part.fixed) place = place.joint(part.joint);
      const int link = graph_.child_of_joint[at(next.joint)];
      if (part.fixed) refuseForceSensors(link, "is fixed to " + quoted(part.parent.name));
      checkWheels(robot_.links[at(link)], &part, diagnostics_);
      addLink(place, link, open, part.joint.axis);
    }
    model_.tree = builder.draft();
    reportMassless();
  }

  /// Hangs a link on its place, which a joint turns about `axis`; the joints below it go on the list so that the first
  /// of the file comes next.
  void addLink(const TreePlace& place, int index, std::vector<Open>& open, const Vector3& axis) {
    const LinkPart& link = robot_.links[at(index)];
    place.body(link.body);
    addMounts(link, axis);
    const std::vector<int>& below = graph_.joints_below[at(index)];
    const TreePlace branch = below.size() > 1 ? place.fork() : place;
    for (auto joint = below.rbegin(); joint != below.rend(); ++joint) open.push_back({branch, *joint});
  }

  void addMounts(const LinkPart& link, const Vector3& axis) {
    const int body = body_count_++;
    const auto mount = [body](auto& list, auto thing) {
      thing.body = body;
      list.push_back(std::move(thing));
    };
    for (const Sole& sole : link.soles) mount(model_.soles, sole);
    for (const ImuMount& imu : link.imus) mount(model_.imus, imu);
    for (const PressureSensorMount& sensor : link.pressure_sensors) mount(model_.pressure_sensors, sensor);
    for (const TouchSensorMount& sensor : link.touch_sensors) mount(model_.touch_sensors, sensor);
    for (const ForceSensorMount& sensor : link.force_sensors) mount(model_.force_sensors, sensor);
    for (WheelMount wheel : link.wheels) {
      if (wheel.feet != WheelFeet::kCastor) wheel.axle = axis;
      mount(model_.wheels, wheel);
    }
    for (const CameraPart& camera : link.cameras) {
      mount(model_.cameras, camera.mount);
      hides_.push_back(&camera.hides);
    }
    for (const RangeSensorPart& sensor : link.range_sensors) {
      mount(model_.range_sensors, sensor.mount);
      ranges_hide_.push_back(&sensor.hides);
    }
  }

  void reportMassless() {
    for (const int joint : masslessJoints(model_.tree)) {
      if (joint >= 0) {
        const Joint& still = model_.tree.joints[at(joint)];
        diagnostics_.error(still.where, "joint " + quoted(still.name) +
                                            " moves no mass, expected an <inertial> in the link that it moves");
      } else {
        const Body& root = model_.tree.bodies[0];
        diagnostics_.error(root.where, "link " + quoted(root.name) + " has no mass, expected an <inertial>");
      }
    }
  }

  void addJointSensors() {
    for (std::size_t j = 0; j < model_.tree.joints.size(); ++j) {
      const Joint& joint = model_.tree.joints[j];
      const auto part = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                     [&](const JointPart& p) { return p.joint.name == joint.name; });
      if (!part->sensor_resolution && !joint.servo) continue;
      const double resolution = part->sensor_resolution ? *part->sensor_resolution : joint.servo->resolution;
      model_.joint_sensors.push_back({static_cast<int>(j), resolution, joint.where});
    }
  }

  int findBody(const Reference& link) {
    const int body = model_.tree.bodyIndex(link.name);
    if (body >= 0) return body;
    std::vector<std::string> names;
    if (diagnostics_.errorCount() <= 100) {
      for (const Body& b : model_.tree.bodies) names.push_back(b.name);
    }
    diagnostics_.error(link.where,
                       "link " + quoted(link.name) + " does not exist" + nearestName(diagnostics_, link.name, names));
    return -1;
  }

  void resolveHidden(const std::vector<Reference>& hides, std::vector<int>& hidden_bodies) {
    for (const Reference& hidden : hides) {
      const int body = findBody(hidden);
      if (body >= 0) hidden_bodies.push_back(body);
    }
  }

  void resolveCameras() {
    for (std::size_t i = 0; i < hides_.size(); ++i) resolveHidden(*hides_[i], model_.cameras[i].hidden_bodies);
    for (std::size_t i = 0; i < ranges_hide_.size(); ++i)
      resolveHidden(*ranges_hide_[i], model_.range_sensors[i].hidden_bodies);
  }

  void resolveIgnoredPairs() {
    for (const auto& [first, second] : robot_.ignored_pairs) {
      const int a = findBody(first), b = findBody(second);
      if (a >= 0 && b >= 0) model_.ignored_pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
    ignoreNearPairs(model_, robot_.ignore_within);
  }

  /// Names of everything that can have properties; "" is the robot.
  std::vector<std::string> objectNames() const {
    std::vector<std::string> names{""};
    const auto add = [&names](const auto& list) {
      for (const auto& thing : list) names.push_back(thing.name);
    };
    add(model_.tree.bodies), add(model_.tree.joints), add(model_.soles);
    add(model_.cameras), add(model_.imus), add(model_.pressure_sensors);
    add(model_.touch_sensors), add(model_.force_sensors);
    add(model_.range_sensors), add(model_.wheels);
    for (const JointPart& part : robot_.joints) names.push_back(part.joint.name);  // those that are fixed, too
    return names;
  }

  void resolveProperties() {
    const std::vector<std::string> names = objectNames();
    const std::set<std::string> known(names.begin(), names.end());
    for (const auto& [key, text] : robot_.properties) {
      if (known.count(key.object) == 0) {
        diagnostics_.error(text.where, "object " + quoted(key.object) + " does not exist in this robot" +
                                           nearestName(diagnostics_, key.object, names));
      } else if (const auto [first, added] = model_.properties.emplace(key, text); !added) {
        diagnostics_.error(text.where, "property " + quoted(key.property) +
                                           fmt::format(" is set in line {} already", first->second.where.line));
      }
    }
  }

  const RobotPart& robot_;
  const LinkGraph& graph_;
  Diagnostics& diagnostics_;
  RobotModel model_;
  int body_count_ = 0;
  std::vector<const std::vector<Reference>*> hides_;        ///< of each camera of the model
  std::vector<const std::vector<Reference>*> ranges_hide_;  ///< of each range sensor
};

}  // namespace

std::optional<RobotModel> assembleRobot(const RobotPart& robot, Diagnostics& diagnostics, bool parts_are_whole) {
  if (robot.links.empty()) {
    diagnostics.error(robot.where, "<robot>: it has no <link>, expected at least one");
    return std::nullopt;
  }
  if (robot.links.size() > kMostLinks || robot.joints.size() > kMostLinks) {
    diagnostics.error(robot.where, fmt::format("<robot>: it has {} links and {} joints, expected at most {} of each",
                                               robot.links.size(), robot.joints.size(), kMostLinks));
    return std::nullopt;
  }
  const int before = diagnostics.errorCount();
  checkNames(robot, diagnostics);
  const LinkGraph graph = connectLinks(robot, diagnostics);
  if (!parts_are_whole || diagnostics.errorCount() != before) return std::nullopt;
  try {
    RobotModel model = Assembler(robot, graph, diagnostics).run();
    if (diagnostics.errorCount() == before) return model;
  } catch (const std::invalid_argument& fault) {  // what only the whole shows, as rounding on the way
    diagnostics.error(robot.where, fault.what());
  }
  return std::nullopt;
}

}  // namespace murosimf::urdf
