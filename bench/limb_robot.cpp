#include "limb_robot.h"

#include <fmt/format.h>

#include <array>

#include "murosimf/math/elementary.h"
#include "murosimf/robot/tree_builder.h"

namespace murosimf::bench {

namespace {

constexpr int kLimbJoints = 5;
constexpr double kThigh = 0.1, kAnkleHeight = 0.03;  // [m]
constexpr Vector3 kSoleSize{0.13, 0.08, 0.012};

const ServoParameters& servo() {
  static const ServoParameters parameters{"strong", 10, 10, 60, 0.5, 0.005, 0};
  return parameters;
}

Body link(const std::string& name, double mass, const Vector3& edges, const Vector3& centre) {
  Body body;
  body.name = name;
  body.mass = boxMass(mass, edges, centre);
  return body;
}

Body foot(const std::string& name) {
  const Vector3 centre{0.01, 0, -kAnkleHeight + kSoleSize.z / 2};
  Body body = link(name, 0.1, kSoleSize, centre);
  BodyShape& shape = body.shapes.emplace_back();
  shape.shape = {ShapeKind::kBox, kSoleSize * 0.5};
  shape.X_BS.translation = centre;
  shape.surface = "sole";
  return body;
}

/// @param side  1 left, -1 right
void addLeg(const TreePlace& trunk, double side, const std::string& name) {
  const Vector3 edges{0.04, 0.04, kThigh}, middle{0, 0, -kThigh / 2}, down{0, 0, -kThigh};
  const auto joint = [&](const TreePlace& at, const char* what, const Vector3& axis) {
    return at.revolute(fmt::format("{}_{}", what, name), axis, {-2, 2, 10, 10}, servo());
  };
  TreePlace at = joint(trunk.translation({0, 0.05 * side, 0}), "hip_roll", kAxisX);
  at = joint(at.body(link("hip_" + name, 0.05, {0.03, 0.03, 0.03}, {})), "hip_pitch", kAxisY);
  at = joint(at.body(link("thigh_" + name, 0.15, edges, middle)).translation(down), "knee", kAxisY);
  at = joint(at.body(link("shank_" + name, 0.1, edges, middle)).translation(down), "ankle_pitch", kAxisY);
  at = joint(at.body(link("ankle_" + name, 0.05, {0.03, 0.03, 0.03}, {})), "ankle_roll", kAxisX);
  at.body(foot("foot_" + name));
}

void addArm(const TreePlace& trunk, double angle, const std::string& name) {
  constexpr std::array<Vector3, 3> kAxes{kAxisY, kAxisZ, kAxisX};
  constexpr double kLength = 0.03;
  TreePlace at = trunk.rotation(rotationZ(angle)).translation({0.06, 0, 0.1});
  for (int i = 0; i < kLimbJoints; ++i) {
    at = at.revolute(fmt::format("{}_{}", name, i), kAxes[static_cast<std::size_t>(i % 3)], {-2, 2, 10, 10}, servo());
    at.body(link(fmt::format("{}_link_{}", name, i), 0.01, {kLength, 0.02, 0.02}, {kLength / 2, 0, 0}));
    if (i + 1 < kLimbJoints) at = at.translation({kLength, 0, 0});
  }
}

Sole soleOn(const KinematicTree& tree, const std::string& name, Side side) {
  Sole sole;
  sole.name = "sole_" + name, sole.side = side;
  sole.body = tree.bodyIndex("foot_" + name);
  sole.X_BSole.translation = {0.01, 0, -kAnkleHeight};
  sole.length = kSoleSize.x, sole.width = kSoleSize.y;
  return sole;
}

}  // namespace

RobotBlueprint limbRobot(int joints) {
  TreeBuilder builder;
  const TreePlace trunk = builder.base("trunk").body(link("trunk", 2, {0.1, 0.14, 0.15}, {0, 0, 0.07})).fork();
  addLeg(trunk, -1, "right");
  addLeg(trunk, 1, "left");
  const int arms = joints / kLimbJoints - 2;
  for (int i = 0; i < arms; ++i) addArm(trunk, 2 * kPi * i / arms, fmt::format("arm{}", i));
  RobotModel model;
  model.name = fmt::format("limbs{}", joints);
  model.tree = builder.build();
  model.soles = {soleOn(model.tree, "right", Side::kRight), soleOn(model.tree, "left", Side::kLeft)};
  model.imus.push_back({"imu", model.tree.bodyIndex("trunk"), {{}, {0, 0, 0.07}}, {}});
  RobotBlueprint made{std::move(model), {}};
  made.flat = flattenTree(made.model.tree);
  return made;
}

}  // namespace murosimf::bench
