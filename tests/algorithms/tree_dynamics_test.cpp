// Forward and inverse dynamics of trees against each other and against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "algorithms/random_tree.h"

namespace murosimf::test {
namespace {

double largest(const std::vector<double>& numbers) {
  double result = 0;
  for (const double x : numbers) result = std::max(result, std::fabs(x));
  return result;
}
double size(const SpatialMotion<double>& a) {
  return std::max(
      {std::fabs(a.w.x), std::fabs(a.w.y), std::fabs(a.w.z), std::fabs(a.v.x), std::fabs(a.v.y), std::fabs(a.v.z)});
}

/// Accelerations by the mass matrix: base first (w, v), then joints.
std::vector<double> byMassMatrix(RandomTree<double>& t) {
  const int bodies = static_cast<int>(t.bodies());
  std::vector<double> bias(t.q.size()), zero(t.q.size(), 0.0);
  std::vector<SpatialMotion<double>> still(t.bodies());
  std::vector<SpatialForce<double>> transmitted(t.bodies());
  inverseDynamics(
      t.rows.data(), bodies,
      InverseDynamics<double>{t.turn.data(), t.dq.data(), zero.data(), t.joint_inertia.data(), t.inertia.data(),
                              t.velocity.data(), t.force.data(), still.data(), bias.data(), transmitted.data()});
  std::vector<RigidInertia<double>> composite(t.bodies());
  std::vector<double> matrix(static_cast<std::size_t>(t.matrix_plan.entries));
  const UnknownRow* unknowns = t.matrix_plan.unknowns.data();
  const int count = static_cast<int>(t.matrix_plan.unknowns.size());
  massMatrix(
      t.rows.data(), bodies, unknowns,
      CompositeBody<double>{t.turn.data(), t.joint_inertia.data(), t.inertia.data(), composite.data(), matrix.data()});
  factorise(unknowns, count, matrix.data());
  std::vector<double> x{-transmitted[0].n.x, -transmitted[0].n.y, -transmitted[0].n.z,
                        -transmitted[0].f.x, -transmitted[0].f.y, -transmitted[0].f.z};
  for (std::size_t j = 0; j < t.q.size(); ++j) x.push_back(t.torque[j] - bias[j]);
  solveFactorised(unknowns, count, matrix.data(), x.data());
  return x;
}

TEST(TreeDynamics, ArticulatedBodyEqualsCompositeBodyOnRandomTrees) {
  for (int joints = 1; joints <= 40; ++joints) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      RandomTree<double> t(joints, seed * 1000 + static_cast<unsigned>(joints), {seed});
      articulatedBody(t.tree(), t.articulated());
      const std::vector<double> reference = byMassMatrix(t);
      const double scale = largest(reference);
      const SpatialMotion<double>& a = t.acceleration[0];
      const double base[6] = {a.w.x, a.w.y, a.w.z, a.v.x, a.v.y, a.v.z};
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(base[k], reference[k], 1e-10 * scale) << joints << " " << seed;
      for (std::size_t j = 0; j < t.q.size(); ++j) EXPECT_NEAR(t.ddq[j], reference[j + 6], 1e-10 * scale) << joints;
    }
  }
}

TEST(TreeDynamics, InverseDynamicsOfTheResultGivesTheTorquesBackAndNoForceAtTheBase) {
  for (int joints = 1; joints <= 40; ++joints) {
    RandomTree<double> t(joints, static_cast<unsigned>(joints), {static_cast<unsigned>(joints)});
    articulatedBody(t.tree(), t.articulated());
    const std::vector<SpatialMotion<double>> found = t.acceleration;
    std::vector<double> torque(t.q.size());
    std::vector<SpatialForce<double>> transmitted(t.bodies());
    inverseDynamics(t.rows.data(), static_cast<int>(t.bodies()),
                    InverseDynamics<double>{t.turn.data(), t.dq.data(), t.ddq.data(), t.joint_inertia.data(),
                                            t.inertia.data(), t.velocity.data(), t.force.data(), t.acceleration.data(),
                                            torque.data(), transmitted.data()});
    double scale = largest(t.ddq);
    for (const auto& a : found) scale = std::max(scale, size(a));
    for (std::size_t i = 0; i < t.bodies(); ++i) EXPECT_LT(size(t.acceleration[i] - found[i]), 1e-10 * scale);
    for (std::size_t j = 0; j < torque.size(); ++j) EXPECT_NEAR(torque[j], t.torque[j], 1e-10 * scale) << joints;
    EXPECT_LT(norm(transmitted[0].n) + norm(transmitted[0].f), 1e-10 * scale);
  }
}

template <class S>
void expectLanesEqualScalar() {
  constexpr int kLanes = RandomTree<S>::kLanes;
  std::vector<unsigned> seeds;
  for (int lane = 0; lane < kLanes; ++lane) seeds.push_back(100 + static_cast<unsigned>(lane));
  RandomTree<S> wide(24, 7, seeds);
  articulatedBody(wide.tree(), wide.articulated());
  for (int lane = 0; lane < kLanes; ++lane) {
    RandomTree<double> one(24, 7, {seeds[static_cast<std::size_t>(lane)]});
    articulatedBody(one.tree(), one.articulated());
    for (std::size_t j = 0; j < one.ddq.size(); ++j) {
      const double in_lane = reinterpret_cast<const double*>(&wide.ddq[j])[lane];
      EXPECT_EQ(std::memcmp(&in_lane, &one.ddq[j], sizeof(double)), 0) << "lane " << lane << " joint " << j;
    }
  }
}

TEST(TreeDynamics, LanesEqualScalarBitForBit) { expectLanesEqualScalar<Pack<double, 4>>(); }

/// A rod of length l and mass m on a pivot that is held: the base is very heavy.
RandomTree<double> rodPendulum(double m, double l, double q, double dq) {
  RandomTree<double> t(1, 3, {1});
  t.table.rows[1] = {0, JointKind::kRevolute, 1, false, {}};
  t.rows = kernelRows(t.table);
  t.inertia[0] = {1e12, {0, 0, 0}, {1e12, 1e12, 1e12, 0, 0, 0}};
  t.inertia[1] =
      shifted(RigidInertia<double>{m, {0, 0, 0}, {0, m * l * l / 12, m * l * l / 12, 0, 0, 0}}, {l / 2, 0, 0});
  t.force[0] = {{0, 0, 0}, {0, 0, 1e12 * 9.81}}, t.force[1] = {{0, 0, 0}, {0, 0, 0}};
  t.joint_inertia[0] = 0, t.q[0] = q, t.dq[0] = dq;
  t.turn[0] = sincos(q);
  t.velocity[0] = {{0, 0, 0}, {0, 0, 0}}, t.up[0] = {0, 0, 1};
  treeMotion(t.rows.data(), 2,
             TreeMotion<double>{t.turn.data(), t.dq.data(), t.velocity.data(), t.up.data(), t.up_height.data()});
  return t;
}

TEST(TreeDynamics, RodPendulumFollowsItsClosedForm) {
  const double m = 0.7, l = 0.4, tau = 0.3;
  for (const double q : {-2.0, -0.4, 0.0, 0.9, 3.0}) {
    RandomTree<double> t = rodPendulum(m, l, q, 1.7);
    t.torque[0] = tau;
    articulatedBody(t.tree(), t.articulated());
    // The rod lies along +x at q = 0 and turns about +y: a positive q lowers its end.
    EXPECT_NEAR(t.ddq[0], 3 * (tau + m * 9.81 * l / 2 * std::cos(q)) / (m * l * l), 1e-9) << q;
  }
}

}  // namespace
}  // namespace murosimf::test
