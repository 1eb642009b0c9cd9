// What a robot's frame costs with composite_body_dynamics over what it costs with multibody_dynamics: a humanoid that
// stands, and chains that fly, of which the matrix has most to store.

#include <fmt/format.h>

#include <array>

#include "murosimf/robot/tree_builder.h"
#include "paired_ratio.h"
#include "robot_team.h"

namespace murosimf::bench {
namespace {

constexpr int kRobots = 24, kRounds = 75;

/// The modules of a level with the mass matrix in the place of articulated bodies.
Level byMassMatrix(Level level) {
  level.name = "composite";
  for (std::string& module : level.modules) {
    if (module == "multibody_dynamics") module = "composite_body_dynamics";
  }
  return level;
}

Row costRow(const std::string& name, RobotTeam& composite, RobotTeam& multibody, int lanes) {
  const Comparison c = compareFrames(
                           {[&] { composite.frame(); }}, [&] { multibody.frame(); }, kRounds)
                           .front();
  constexpr double kPerRobot = 1e9 / kRobots;
  Row row{name, 1 / c.ratio, c.ours * kPerRobot, c.peer * kPerRobot, "ns/robot-frame", isaOf(lanes), ""};
  row.text = fmt::format("{:28} {:7} {:6.2f} times the cost of multibody_dynamics ({:.0f} ns, {:.0f} ns a robot-frame)",
                         row.name, row.isa, row.ratio, row.ours, row.peer);
  return row;
}

Row standingHumanoids(int lanes) {
  RobotTeam multibody(soleWalker(), standingAngles(), multibodyLevel(), kRobots, lanes);
  RobotTeam composite(soleWalker(), standingAngles(), byMassMatrix(multibodyLevel()), kRobots, lanes);
  for (RobotTeam* team : {&multibody, &composite}) team->settle(1), team->stance().require(team->startHeight(), "KS21");
  return costRow("composite_24_vs_multibody", composite, multibody, lanes);
}

/// A base with one limb of so many joints, 3 cm from each to the next.
RobotBlueprint chain(int joints) {
  static const ServoParameters servo{"strong", 10, 10, 60, 0.5, 0.005, 0};
  constexpr std::array<Vector3, 3> kAxes{kAxisY, kAxisZ, kAxisX};
  const auto link = [](const std::string& name, double mass, double edge) {
    Body body;
    body.name = name;
    body.mass = boxMass(mass, {edge, edge, edge}, {edge / 2, 0, 0});
    return body;
  };
  TreeBuilder builder;
  TreePlace at = builder.base("base");
  at.body(link("trunk", 1, 0.1));
  for (int i = 0; i < joints; ++i) {
    at = at.translation({0.03, 0, 0})
             .revolute(fmt::format("joint{}", i), kAxes[static_cast<std::size_t>(i % 3)], {-2, 2, 10, 10}, servo);
    at.body(link(fmt::format("link{}", i), 0.02, 0.03));
  }
  RobotModel model;
  model.name = fmt::format("chain{}", joints);
  model.tree = builder.build();
  RobotBlueprint made{std::move(model), {}};
  made.flat = flattenTree(made.model.tree);
  return made;
}

std::vector<Row> flyingChains() {
  const Level flight{"flight",
                     {"servo_controller", "position_servo", "tree_motion", "multibody_dynamics", "implicit_euler"}};
  std::vector<Row> rows;
  for (const int joints : {3, 6, 12, 24, 48}) {
    const RobotBlueprint print = chain(joints);
    const std::vector<double> q(static_cast<std::size_t>(joints), 0.2);
    RobotTeam multibody(print, q, flight, kRobots, widestLanes());
    RobotTeam composite(print, q, byMassMatrix(flight), kRobots, widestLanes());
    rows.push_back(
        costRow(fmt::format("composite_chain_{}_vs_multibody", joints), composite, multibody, widestLanes()));
  }
  return rows;
}

}  // namespace

std::vector<Part> fullDynamicsParts() {
  std::vector<Part> parts;
  for (const int lanes : laneWidths())
    parts.emplace_back([lanes] { return std::vector<Row>{standingHumanoids(lanes)}; });
  parts.emplace_back(flyingChains);
  return parts;
}

}  // namespace murosimf::bench
