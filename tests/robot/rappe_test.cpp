/// @file The numbers of robots/rappe.urdf: what was designed is what is read.

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/robot/flatten_tree.h"
#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

const RobotModel& rappe() {
  static const RobotModel model = [] {
    Diagnostics diagnostics;
    ReadResult result = readUrdf(MUROSIMF_SOURCE_DIR "/robots/rappe.urdf", diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    return result ? *result : RobotModel{};
  }();
  return model;
}

/// Moments of a homogeneous shape of 1 kg about its axes.
Vector3 momentsOf(const Shape& shape) {
  const Vector3& h = shape.half_size;
  const Vector3 square{h.x * h.x, h.y * h.y, h.z * h.z};
  switch (shape.kind) {
    case ShapeKind::kBox:
      return Vector3{square.y + square.z, square.x + square.z, square.x + square.y} * (1.0 / 3);
    case ShapeKind::kCylinder: {
      const double across = square.x / 4 + square.z / 3;
      return {across, across, square.x / 2};
    }
    case ShapeKind::kEllipsoid:
      return Vector3{square.y + square.z, square.x + square.z, square.x + square.y} * 0.2;
    case ShapeKind::kCapsule:
    case ShapeKind::kConvex:
      break;
  }
  return {};
}

TEST(Rappe, HasFourLegsOfThreeJointsAndElevenKilograms) {
  const KinematicTree& tree = rappe().tree;
  EXPECT_EQ(tree.joints.size(), 12U);
  EXPECT_EQ(flattenTree(tree).row_names.size(), 13U);
  EXPECT_NEAR(tree.mass(), 11.04, 1e-12);
  EXPECT_TRUE(rappe().soles.empty());
  EXPECT_EQ(rappe().imus.size(), 1U);
}

TEST(Rappe, BodiesAreHomogeneousOfTheirDrawnShapes) {
  for (const Body& body : rappe().tree.bodies) {
    ASSERT_FALSE(body.shapes.empty()) << body.name;
    const BodyShape& s = body.shapes.front();
    const SymmetricMatrix& I = body.mass.I_C_B;
    EXPECT_LT(norm(body.mass.p_BC_B - s.X_BS.translation), 1e-12) << body.name;
    const Vector3 own = momentsOf(s.shape) * body.mass.mass;
    const Rotation3& R = s.X_BS.rotation;
    for (const auto& [u, moment] : {std::pair{R.x, own.x}, {R.y, own.y}, {R.z, own.z}}) {
      const Vector3 Iu{I.xx * u.x + I.xy * u.y + I.xz * u.z, I.xy * u.x + I.yy * u.y + I.yz * u.z,
                       I.xz * u.x + I.yz * u.y + I.zz * u.z};
      EXPECT_LT(norm(Iu - u * moment), 1e-6 * norm(own)) << body.name;
    }
  }
}

TEST(Rappe, LegsAreMirrorImagesAndStraightOnesReachTheSameGround) {
  const KinematicTree& tree = rappe().tree;
  const std::vector<Pose> elements = elementPoses(tree, std::vector<double>(12, 0.0));
  for (const char* end : {"front", "rear"}) {
    const auto hoof = [&](const char* side) {
      const std::string name = std::string("hoof_") + end + "_" + side;
      const Body& body = tree.bodies.at(static_cast<std::size_t>(tree.bodyIndex(name)));
      return elements[static_cast<std::size_t>(body.element)].translation;
    };
    const Vector3 right = hoof("right"), left = hoof("left");
    EXPECT_LT(norm(right - Vector3{end[0] == 'f' ? 0.17 : -0.17, -0.11, -0.40}), 1e-12) << end;
    EXPECT_LT(norm(left - Vector3{right.x, -right.y, right.z}), 1e-12) << end;
  }
}

TEST(Rappe, ServosHoldTwiceTheTorqueOfATrottingKnee) {
  // Two legs carry the robot, knees 13 cm before the line of the force: hips .30 m above the hooves, links of .20 m.
  const double arm = std::sqrt(0.2 * 0.2 - 0.15 * 0.15), torque = 0.5 * 11.04 * 9.81 * arm;
  for (const Joint& joint : rappe().tree.joints) {
    ASSERT_TRUE(joint.servo.has_value());
    EXPECT_GT(joint.servo->stall_torque, 2 * torque) << joint.name;
  }
}

}  // namespace
}  // namespace murosimf
