// Forward and inverse dynamics of trees against each other and against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "algorithms/random_tree.h"
#include "book/page.h"
#include "murosimf/algorithms/inverse_dynamics.h"

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

/// All accelerations that a tree has found: bodies, then joints.
std::vector<double> accelerations(const RandomTree<double>& t) {
  std::vector<double> all = t.ddq;
  for (const auto& a : t.acceleration) all.insert(all.end(), {a.w.x, a.w.y, a.w.z, a.v.x, a.v.y, a.v.z});
  return all;
}

template <class S>
void byArticulatedBodies(RandomTree<S>& t) {
  articulatedInward(t.tree(), t.articulated(),
                    [&](int i, ArticulatedInertia<S>& Ic, SpatialForce<S>&) { t.addContact(i, Ic); });
  articulatedOutward(t.tree(), t.articulated());
}
template <class S>
void byCompositeBodies(RandomTree<S>& t) {
  compositeBody(t.tree(), t.composite(),
                [&](int i, ArticulatedInertia<S>& Ic, SpatialForce<S>&) { t.addContact(i, Ic); });
}

TEST(TreeDynamics, ArticulatedBodyEqualsCompositeBodyOnRandomTreesInFlightAndInContact) {
  for (int joints = 0; joints <= 40; ++joints) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      RandomTree<double> t(joints, seed * 1000 + static_cast<unsigned>(joints), {seed});
      if (seed % 2 == 1) t.touchGround({seed});
      byArticulatedBodies(t);
      const std::vector<double> one = accelerations(t);
      byCompositeBodies(t);
      const std::vector<double> other = accelerations(t);
      const double scale = largest(one);
      for (std::size_t k = 0; k < one.size(); ++k)
        EXPECT_NEAR(one[k], other[k], 1e-10 * scale) << joints << " " << seed;
    }
  }
}

/// Inverse dynamics of the accelerations that t has found, f = f0 - K a where it touches.
struct Inverse {
  std::vector<double> torque;
  std::vector<SpatialForce<double>> transmitted;
  std::vector<SpatialMotion<double>> acceleration;
  explicit Inverse(RandomTree<double>& t) : torque(t.q.size()), transmitted(t.bodies()), acceleration(t.acceleration) {
    std::vector<SpatialForce<double>> force = t.force;
    for (std::size_t i = 0; i < t.bodies(); ++i) {
      if (t.touch[i] > 0) force[i] = force[i] - t.contact[i] * t.acceleration[i];
    }
    inverseDynamics(t.rows.data(), static_cast<int>(t.bodies()),
                    InverseDynamics<double>{t.turn.data(), t.dq.data(), t.ddq.data(), t.joint_inertia.data(),
                                            t.inertia.data(), t.velocity.data(), force.data(), acceleration.data(),
                                            torque.data(), transmitted.data()});
  }
};

TEST(TreeDynamics, InverseDynamicsOfTheResultGivesTheTorquesBackAndNoForceAtTheBase) {
  for (int joints = 1; joints <= 40; ++joints) {
    for (const bool composite : {false, true}) {
      const auto seed = static_cast<unsigned>(joints);
      RandomTree<double> t(joints, seed, {seed});
      if (joints % 2 == 1) t.touchGround({seed});
      composite ? byCompositeBodies(t) : byArticulatedBodies(t);
      const Inverse back(t);
      const double scale = largest(accelerations(t));
      for (std::size_t i = 0; i < t.bodies(); ++i)
        EXPECT_LT(size(back.acceleration[i] - t.acceleration[i]), 1e-10 * scale);
      // Forces of contacts, K a, are larger than those of bodies.
      const double torques = 1e-10 * scale * (joints % 2 == 1 ? 20 : 1);
      for (std::size_t j = 0; j < t.q.size(); ++j) EXPECT_NEAR(back.torque[j], t.torque[j], torques) << joints;
      EXPECT_LT(norm(back.transmitted[0].n) + norm(back.transmitted[0].f), torques);
    }
  }
}

/// What the mass matrix has for motions j and k, j <= k: of the base (0 to 5), or of joint j - 6.
double entryOf(const RandomTree<double>& t, const BaseEquation<double>& base, int k, int j) {
  SpatialMotion<double> unit{};
  if (j < 6) reinterpret_cast<double*>(&unit)[j] = 1;
  const SpatialForce<double> column = base.Ic * unit;
  if (k < 6) return reinterpret_cast<const double*>(&column)[k];
  const std::vector<MatrixRow>& rows = t.matrix_plan.rows;
  const double* row = t.matrix.data() + rows[static_cast<std::size_t>(k - 6)].offset;
  if (j < 6) return row[j];
  for (int i = k - 6; i >= 0; i = rows[static_cast<std::size_t>(i)].parent) {
    if (i == j - 6) return row[6 + rows[static_cast<std::size_t>(i)].depth];
  }
  return 0;  // on different branches
}

TEST(TreeDynamics, ColumnsOfTheMassMatrixAreWhatUnitAccelerationsNeed) {
  for (int joints = 1; joints <= 40; joints += 3) {
    RandomTree<double> t(joints, 5 + static_cast<unsigned>(joints), {3});
    t.touchGround({3});
    const auto composite = t.composite();
    const BaseEquation<double> base =
        compositeInward(t.tree(), composite,
                        [&](int i, ArticulatedInertia<double>& Ic, SpatialForce<double>&) { t.addContact(i, Ic); });
    fillRows(t.tree(), composite);
    // At rest, without forces, only accelerations need any.
    std::fill(t.dq.begin(), t.dq.end(), 0.0), std::fill(t.velocity.begin(), t.velocity.end(), SpatialMotion<double>{});
    std::fill(t.force.begin(), t.force.end(), SpatialForce<double>{});
    for (int k = 0; k < joints + 6; ++k) {
      std::fill(t.ddq.begin(), t.ddq.end(), 0.0);
      t.acceleration[0] = {};
      if (k < 6) reinterpret_cast<double*>(t.acceleration.data())[k] = 1;
      if (k >= 6) t.ddq[static_cast<std::size_t>(k - 6)] = 1;
      accelerateOutward(t.tree(), composite.tree, [&](int i, const auto&) { return k == i + 5 ? 1.0 : 0.0; });
      const Inverse column(t);
      for (int j = k; j < joints + 6; ++j) {
        const auto* at_base = reinterpret_cast<const double*>(column.transmitted.data());
        const double needed = j < 6 ? at_base[j] : column.torque[static_cast<std::size_t>(j - 6)];
        EXPECT_NEAR(entryOf(t, base, j, k), needed, 1e-10 * base.Ic.M.xx) << joints << " " << j << " " << k;
      }
    }
  }
}

template <class S, class Dynamics>
void expectLanesEqualScalar(const Dynamics& dynamics) {
  constexpr int kLanes = RandomTree<S>::kLanes;
  std::vector<unsigned> seeds;
  for (int lane = 0; lane < kLanes; ++lane) seeds.push_back(100 + static_cast<unsigned>(lane));
  for (const bool in_contact : {false, true}) {
    RandomTree<S> wide(24, 7, seeds);
    if (in_contact) wide.touchGround(seeds);
    dynamics(wide);
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::vector<unsigned> seed{seeds[static_cast<std::size_t>(lane)]};
      RandomTree<double> one(24, 7, seed);
      if (in_contact) one.touchGround(seed);
      dynamics(one);
      for (std::size_t j = 0; j < one.ddq.size(); ++j) {
        const double in_lane = reinterpret_cast<const double*>(&wide.ddq[j])[lane];
        EXPECT_EQ(std::memcmp(&in_lane, &one.ddq[j], sizeof(double)), 0) << "lane " << lane << " joint " << j;
      }
    }
  }
}

TEST(TreeDynamics, LanesEqualScalarBitForBit) {
  expectLanesEqualScalar<Pack<double, 4>>([](auto& t) { byArticulatedBodies(t); });
  expectLanesEqualScalar<Pack<double, 4>>([](auto& t) { byCompositeBodies(t); });
}

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
  book::Page page(
      {book::Chapter::kMechanisms,
       "Forward dynamics of a rod pendulum is its closed form",
       R"(\ddot q = \frac{3 (\tau + m g \frac{l}{2} \cos q)}{m l^2})",
       "Euler about the joint [Featherstone 2008]",
       {{"\\tau", "torque, here 0.3", "N m"}, {"m", "mass, here 0.7", "kg"}, {"l", "length, here 0.4", "m"}},
       {"angle $q$", "rad"},
       {"acceleration $\\ddot q$", "rad/s^2"}});
  const double m = 0.7, l = 0.4, tau = 0.3;
  const auto acceleration = [&](double q) { return 3 * (tau + m * 9.81 * l / 2 * std::cos(q)) / (m * l * l); };
  page.curve(-2, 3, acceleration);
  for (const double q : {-2.0, -0.4, 0.0, 0.9, 3.0}) {
    RandomTree<double> t = rodPendulum(m, l, q, 1.7);
    t.torque[0] = tau;
    articulatedBody(t.tree(), t.articulated());
    // The rod lies along +x at q = 0 and turns about +y: a positive q lowers its end.
    EXPECT_TRUE(page.near(q, t.ddq[0], acceleration(q), 1e-9));
  }
}

}  // namespace
}  // namespace murosimf::test
