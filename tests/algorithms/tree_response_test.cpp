// How a tree of bodies answers impulses, against forward dynamics of trees at rest.

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/random_tree.h"
#include "algorithms/rigid_response.h"
#include "murosimf/algorithms/tree_response.h"

namespace murosimf::test {
namespace {

struct AtRest {
  RandomTree<double> tree;
  std::vector<Pose> X_WB;
  TreeResponse::Constants constants;

  AtRest(int joints, unsigned seed) : tree(joints, seed, {seed}) {
    std::fill(tree.dq.begin(), tree.dq.end(), 0.0);
    std::fill(tree.torque.begin(), tree.torque.end(), 0.0);
    std::fill(tree.velocity.begin(), tree.velocity.end(), SpatialMotion<double>{});
    std::fill(tree.force.begin(), tree.force.end(), SpatialForce<double>{});
    X_WB.push_back({rotationExp(Vector3{0.3, -1.1, 0.7}), {4, -3, 0.4}});
    for (std::size_t i = 1; i < tree.rows.size(); ++i) {
      X_WB.push_back(childPose(X_WB[static_cast<std::size_t>(tree.rows[i].parent)], tree.rows[i], tree.q[i - 1]));
    }
    constants = {tree.table, tree.inertia, tree.joint_inertia};
  }
  const Rotation3& rotation(std::size_t body) const { return X_WB[body].rotation; }
  Vector3 arm(std::size_t body) const { return X_WB[body].translation - X_WB[0].translation; }
  /// Acceleration of a body by a force on another one, both in world axes about the base's origin.
  SpatialMotion<double> accelerated(std::size_t body, std::size_t pushed, const SpatialForce<double>& force_O) {
    const SpatialForce<double> about_body{force_O.n - cross(arm(pushed), force_O.f), force_O.f};
    std::fill(tree.force.begin(), tree.force.end(), SpatialForce<double>{});
    tree.force[pushed] = {applyTransposed(rotation(pushed), about_body.n),
                          applyTransposed(rotation(pushed), about_body.f)};
    articulatedBody(tree.tree(), tree.articulated());
    const SpatialMotion<double>& a = tree.acceleration[body];
    const Vector3 w = rotation(body) * a.w;
    return {w, rotation(body) * a.v - cross(w, arm(body))};
  }
};

TEST(TreeResponse, EqualsTheAccelerationsOfForwardDynamicsAtRest) {
  for (const int joints : {0, 1, 3, 8, 21, 40}) {
    AtRest robot(joints, static_cast<unsigned>(7 + joints));
    TreeResponse response(robot.constants);
    response.place(robot.X_WB, true);
    const std::vector<int> bodies{0, joints / 2, joints};
    std::vector<ResponseBlock> blocks(bodies.size() * bodies.size());
    response.respond(bodies, blocks);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      for (std::size_t b = 0; b < 6; ++b) {
        Vector3 parts[2];
        parts[b / 3][static_cast<int>(b % 3)] = 1;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
          const SpatialMotion<double> a = robot.accelerated(static_cast<std::size_t>(bodies[i]),
                                                            static_cast<std::size_t>(bodies[j]), {parts[0], parts[1]});
          const double numbers[] = {a.w.x, a.w.y, a.w.z, a.v.x, a.v.y, a.v.z};
          for (std::size_t k = 0; k < 6; ++k) {
            const double scale = 1 + std::abs(numbers[k]);
            const double found = blocks[bodies.size() * i + j].row[b][k];
            EXPECT_NEAR(found, numbers[k], 1e-9 * scale) << joints;
            EXPECT_NEAR(found, blocks[bodies.size() * j + i].row[k][b], 1e-9 * scale);
          }
        }
      }
    }
  }
}

TEST(TreeResponse, OfALoneBodyIsThatOfARigidOne) {
  AtRest robot(0, 5);
  TreeResponse tree(robot.constants);
  tree.place(robot.X_WB, true);
  const RigidInertia<double>& body = robot.tree.inertia[0];
  const Rotation3& R = robot.rotation(0);
  const Vector3 com = body.mc * (1 / body.m);
  const RigidInertia<double> about_com = shifted(body, -com);
  const Symmetric3<double> I = turned(R, about_com.I);
  const Vector3 x{I.xx, I.xy, I.xz}, y{I.xy, I.yy, I.yz}, z{I.xz, I.yz, I.zz};
  const double over_determinant = 1 / dot(x, cross(y, z));
  const Rotation3 inverse{cross(y, z) * over_determinant, cross(z, x) * over_determinant,
                          cross(x, y) * over_determinant};
  const RigidResponse rigid(robot.X_WB[0].translation, body.m, robot.X_WB[0] * com, inverse);
  const int bodies[] = {0};
  std::vector<ResponseBlock> a(1);
  tree.respond(bodies, a);
  const std::vector<ResponseBlock> b = blocksOf(rigid, bodies);
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(a[0].row[r][k], b[0].row[r][k], 1e-9 * (1 + std::abs(b[0].row[r][k])));
  }
}

TEST(TreeResponse, OfJointsThatAreHeldIsThatOfTheWholeTreeAsOneBody) {
  AtRest robot(12, 3);
  TreeResponse response(robot.constants);
  response.place(robot.X_WB, false);
  const int bodies[] = {0, 5, 12};
  std::vector<ResponseBlock> blocks(9);
  response.respond(bodies, blocks);
  for (const ResponseBlock& block : blocks) {
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(block.row[r][k], blocks[0].row[r][k]);
    }
  }
}

}  // namespace
}  // namespace murosimf::test
