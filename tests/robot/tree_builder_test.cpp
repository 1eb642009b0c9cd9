/// @file What the builder refuses, and what it makes.

#include "murosimf/robot/tree_builder.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

namespace murosimf {
namespace {

const MassProperties kCube = boxMass(1, {0.1, 0.1, 0.1}, {});
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The words of the exception that a call throws; "" when it throws none.
std::string refusal(const std::function<void(const TreePlace&)>& call) {
  TreeBuilder builder;
  const TreePlace base = builder.base("base").body({.name = "trunk", .mass = kCube});
  try {
    call(base);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(TreeBuilder, RefusesWhatCannotBe) {
  const auto contains = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  const std::vector<std::pair<const char*, std::function<void(const TreePlace&)>>> cases{
      {"second successor",
       [](const TreePlace& b) {
         b.translation({1, 0, 0}), b.translation({2, 0, 0});
       }},
      {"\"trunk\" is used twice", [](const TreePlace& b) { b.body({.name = "trunk", .mass = kCube}); }},
      {"name is empty", [](const TreePlace& b) { b.revolute("", kAxisX); }},
      {"axis has no direction", [](const TreePlace& b) { b.revolute("hinge", {}); }},
      {"axis has no direction",
       [](const TreePlace& b) {
         b.revolute("hinge", {0, kNaN, 1});
       }},
      {"lower limit 1 is above upper limit -1",
       [](const TreePlace& b) { b.revolute("hinge", kAxisX, {.lower = 1, .upper = -1}); }},
      {"lower limit nan", [](const TreePlace& b) { b.revolute("hinge", kAxisX, {.lower = kNaN}); }},
      {"largest velocity is 0", [](const TreePlace& b) { b.prismatic("rail", kAxisX, {.largest_velocity = 0}); }},
      {"stall_torque is 0", [](const TreePlace& b) { b.revolute("hinge", kAxisX, {}, ServoParameters{}); }},
      {"not finite",
       [](const TreePlace& b) {
         b.translation({0, kNaN, 0});
       }},
      {"not orthonormal",
       [](const TreePlace& b) {
         b.rotation({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
       }},
      {"not orthonormal",
       [](const TreePlace& b) {
         b.rotation({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
       }},
      {"mass is -1 kg",
       [](const TreePlace& b) {
         b.body({.name = "b", .mass = boxMass(-1, {1, 1, 1}, {})});
       }},
      {"half sizes",
       [](const TreePlace& b) {
         b.body({.name = "b", .mass = kCube, .shapes = {BodyShape{.shape = makeSphere(-1)}}});
       }},
  };
  for (const auto& [words, call] : cases) EXPECT_TRUE(contains(refusal(call), words)) << words << ": " << refusal(call);
  EXPECT_EQ(refusal([](const TreePlace& b) { b.fork().translation({1, 0, 0}); }), "");
}

TEST(TreeBuilder, RefusesToFinishWithAJointThatMovesNoMass) {
  TreeBuilder builder;
  builder.base("base").body({.name = "trunk", .mass = kCube}).revolute("hinge", kAxisX).body({.name = "frame"});
  EXPECT_THROW(builder.build(), std::invalid_argument);
  EXPECT_EQ(masslessJoints(builder.draft()), std::vector<int>{0});
  EXPECT_THROW(TreeBuilder().build(), std::invalid_argument);
}

TEST(TreeBuilder, BodiesKnowTheJointThatMovesThem) {
  TreeBuilder builder;
  const TreePlace fork = builder.base("base").body({.name = "trunk", .mass = kCube}).fork();
  fork.translation({0, 0, 1}).body({.name = "mark"});
  fork.revolute("hinge", kAxisX).translation({0, 0, 1}).body({.name = "arm", .mass = kCube});
  const KinematicTree tree = builder.build();
  EXPECT_EQ(tree.bodies[0].joint, -1);
  EXPECT_EQ(tree.bodies[1].joint, -1);
  EXPECT_EQ(tree.bodies[2].joint, 0);
  EXPECT_EQ(tree.bodyIndex("arm"), 2);
  EXPECT_EQ(tree.bodyIndex("leg"), -1);
  EXPECT_EQ(tree.jointIndex("hinge"), 0);
}

TEST(TreeBuilder, AxesBecomeUnitVectorsAndRoundingOfCoordinateAxesVanishes) {
  TreeBuilder builder;
  const TreePlace base = builder.base("base").body({.name = "trunk", .mass = kCube}).fork();
  base.revolute("a", {0, 49, 0}).body({.name = "a_body", .mass = kCube});
  base.revolute("b", {1e-12, 0, -3e-8}).body({.name = "b_body", .mass = kCube});
  base.revolute("c", {3, 0, 4}).body({.name = "c_body", .mass = kCube});
  base.revolute("d", {1e-300, 0, 1e-300}).body({.name = "d_body", .mass = kCube});
  const KinematicTree tree = builder.build();
  EXPECT_EQ(tree.joints[0].axis, kAxisY);
  EXPECT_NEAR(tree.joints[1].axis.z, -1, 1e-9);
  EXPECT_NEAR(norm(tree.joints[2].axis - Vector3{0.6, 0, 0.8}), 0, 1e-15);
  EXPECT_NEAR(norm(tree.joints[3].axis), 1, 1e-15);
}

}  // namespace
}  // namespace murosimf
