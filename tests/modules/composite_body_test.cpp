// Full dynamics by the mass matrix against articulated bodies: one motion, two ways to its accelerations.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "modules/ks21_motions.h"
#include "modules/test_rig.h"

namespace murosimf::motion {
namespace {

/// Largest difference of the states of the first robots of two worlds: base [m, 1] and joints [rad, rad/s].
double difference(DynamicWorld& a, DynamicWorld& b) {
  const ObjectId x = a.robots().front(), y = b.robots().front();
  const Pose p = a.base(x), q = b.base(y);
  double most = norm(p.translation - q.translation) + norm(p.rotation.z - q.rotation.z);
  const auto V = a.get(x, kBaseVelocity) - b.get(y, kBaseVelocity);
  most = std::max({most, norm(V.w), norm(V.v)});
  for (int j = 0; j < 21; ++j) {
    for (const auto& property : {kJointPosition, kJointVelocity}) {
      const double one = a.get(x, property, subset::kJoints, j), other = b.get(y, property, subset::kJoints, j);
      most = std::max(most, std::fabs(one - other));
    }
  }
  return most;
}

struct Setting {
  std::string contact, integrator;
  double step;
};
class CompositeBodyDynamics : public testing::TestWithParam<Setting> {
 protected:
  CompositeBodyDynamics() : articulated_(GetParam().step), composite_(GetParam().step) {
    const DynamicLevel level = multibody(GetParam().contact, GetParam().integrator);
    articulated_.add("robot", ks21(), kReady), composite_.add("robot", ks21(), kReady);
    articulated_.link(level), composite_.link(byMassMatrix(level));
  }
  DynamicWorld articulated_, composite_;
};

TEST_P(CompositeBodyDynamics, StandsAsArticulatedBodiesDo) {
  for (int k = 0; k < 5; ++k) {
    articulated_.run(1), composite_.run(1);
    EXPECT_LT(difference(articulated_, composite_), 1e-11) << k + 1 << " s";
  }
  EXPECT_GT(composite_.upright(composite_.robots().front()), 0.99);
}

TEST_P(CompositeBodyDynamics, WalksAsArticulatedBodiesDo) {
  for (int k = 0; k < 150; ++k) {
    const double t = 0.01 * k;
    for (DynamicWorld* world : {&articulated_, &composite_}) {
      world->command(world->robots().front(), gait(t / 0.52, {0.1 * std::min(1.0, t), 0, 0}, std::min(1.0, t)));
      world->run(0.01);
    }
  }
  EXPECT_LT(difference(articulated_, composite_), 1e-9);
  EXPECT_GT(composite_.upright(composite_.robots().front()), 0.97);
  EXPECT_GT(composite_.base(composite_.robots().front()).translation.x, 0.03);
}

INSTANTIATE_TEST_SUITE_P(All, CompositeBodyDynamics,
                         testing::Values(Setting{"hunt_crossley_contact", "implicit_euler", 1e-3},
                                         Setting{"smooth_contact", "implicit_euler", 5e-3},
                                         Setting{"smooth_contact", "runge_kutta_4", 5e-4}),
                         [](const auto& test) { return test.param.integrator + std::to_string(test.index); });

/// Robots that stand, walk and fall, one each way in turn.
void commandAll(DynamicWorld& world, std::size_t first, double t) {
  for (std::size_t i = 0; i < world.robots().size(); ++i) {
    const std::size_t way = (first + i) % 3;
    std::vector<double> q = gait(t / 0.52, {0.02 * static_cast<double>(first + i), 0, 0}, way == 0 ? 0.0 : 1.0);
    if (way == 2) q[11] -= 2 * t, q[17] -= 2 * t;  // bends forward until it lies
    world.command(world.robots()[i], q);
  }
}

TEST(CompositeBodyDynamicsInLanes, EqualScalarBitForBitStandingWalkingAndFalling) {
  for (const int lanes : {4, 8}) {
    DynamicWorld together(1e-3);
    for (int i = 0; i < lanes; ++i) together.add("robot" + std::to_string(i), ks21(), kReady);
    together.link(byMassMatrix(multibody()), lanes);
    for (int k = 0; k < 100; ++k) commandAll(together, 0, 0.01 * k), together.run(0.01);
    EXPECT_LT(together.upright(together.robots()[2]), 0.5) << "the one that was to fall did not";
    for (const std::size_t i : {0U, 1U, 2U}) {
      DynamicWorld alone(1e-3);
      const ObjectId robot = alone.add("robot" + std::to_string(i), ks21(), kReady);
      alone.link(byMassMatrix(multibody()));
      alone.place(0, {0, static_cast<double>(i), 0});
      for (int k = 0; k < 100; ++k) commandAll(alone, i, 0.01 * k), alone.run(0.01);
      const Pose a = together.base(together.robots()[i]), b = alone.base(robot);
      EXPECT_EQ(std::memcmp(&a, &b, sizeof(Pose)), 0) << i << " of " << lanes;
      for (int j = 0; j < 21; ++j) {
        EXPECT_EQ(together.get(together.robots()[i], kJointVelocity, subset::kJoints, j),
                  alone.get(robot, kJointVelocity, subset::kJoints, j));
      }
    }
  }
}

/// A chain of so many links on revolute and prismatic joints.
TestRig chain(int joints) {
  TestRig rig(rigidBody(1, {1, 1, 1}));
  for (int j = 0; j < joints; ++j) {
    const JointKind kind = j % 5 == 4 ? JointKind::kPrismatic : JointKind::kRevolute;
    rig.joint(j, kind, j % 3, {0, 0, 0.1}, rigidBody(0.1, {1e-3, 1e-3, 1e-3}));
  }
  return rig;
}

TEST(CompositeBodyDynamicsOfChains, MoveThemAsArticulatedBodiesDoWithRotorsAndFriction) {
  for (const char* integrator : {"implicit_euler", "runge_kutta_4"}) {
    std::vector<double> found[2];
    for (const bool composite : {false, true}) {
      TestRig rig = chain(15);
      for (int j = 0; j < 15; j += 2) rig.with(j, kArmature, 2e-3).with(j, kJointDamping, 0.01 * (j + 1));
      if (composite) rig.inPlaceOfMultibody("composite_body_dynamics");
      rig.link(integrator, 1e-3);
      rig.set(Pose{}, {{1, 2, 3}, {0.5, 0, 0}});
      for (int j = 0; j < 15; ++j) rig.set(j, 0.1 * j, j % 3 - 1.0);
      rig.run(0.5);
      found[composite ? 1 : 0] = rig.memory();
    }
    ASSERT_EQ(found[0].size(), found[1].size());
    for (std::size_t k = 0; k < found[0].size(); ++k) EXPECT_NEAR(found[0][k], found[1][k], 1e-9) << k << integrator;
    EXPECT_GT(std::fabs(found[0].front()), 0) << "nothing moved";
  }
}

TEST(CompositeBodyDynamicsRefuses, ChainsWhoseMatrixDoesNotFit) {
  EXPECT_NO_THROW(chain(80).inPlaceOfMultibody("composite_body_dynamics").link("implicit_euler", 1e-3));
  try {
    chain(90).inPlaceOfMultibody("composite_body_dynamics").link("implicit_euler", 1e-3);
    FAIL() << "was to be refused";
  } catch (const std::runtime_error& problem) {
    EXPECT_NE(std::string(problem.what()).find("choose multibody_dynamics"), std::string::npos) << problem.what();
  }
}

}  // namespace
}  // namespace murosimf::motion
