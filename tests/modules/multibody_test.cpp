// Multibody dynamics without ground: what free flight conserves.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "modules/flying_robots.h"

namespace murosimf::motion {
namespace {

TEST(MultibodyDynamics, CentreOfMassFliesAParabolaAndMomentumStaysWhileLimbsSwing) {
  constexpr double kTime = 0.2;
  FlyingRobots flight(1, "runge_kutta_4", 1e-4);
  flight.toss(0, 3);
  const auto before = flight.mechanics(0);
  flight.run(kTime);
  const auto after = flight.mechanics(0);
  const Vector3 expected =
      before.centre + before.linear * (kTime / before.mass) + Vector3{0, 0, -0.5 * 9.81 * kTime * kTime};
  EXPECT_LT(norm(after.centre - expected), 1e-10);
  const Vector3 fall{0, 0, -before.mass * 9.81 * kTime};
  EXPECT_LT(norm(after.linear - before.linear - fall), 1e-10 * norm(before.linear));
  EXPECT_LT(norm(after.angular - before.angular), 1e-10 * norm(before.angular));
}

/// Distance of base position and all joint positions from those of a much finer run.
double errorOf(const Method& integrator, double step) {
  constexpr double kTime = 0.096;
  static const std::vector<double> reference = [] {
    FlyingRobots fine(1, "runge_kutta_4", 1e-4);
    fine.toss(0, 3);
    fine.run(kTime);
    return fine.positions(0);
  }();
  FlyingRobots flight(1, integrator, step);
  flight.toss(0, 3);
  flight.run(kTime);
  const std::vector<double> found = flight.positions(0);
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i) sum += (found[i] - reference[i]) * (found[i] - reference[i]);
  return std::sqrt(sum);
}

struct OrderOf {
  Method integrator;
  int order;
  double step;  ///< larger one of two [s]
};
class Integrators : public testing::TestWithParam<OrderOf> {};

TEST_P(Integrators, ConvergeWithTheirOrder) {
  const OrderOf& p = GetParam();
  const double ratio = errorOf(p.integrator, p.step) / errorOf(p.integrator, p.step / 2);
  EXPECT_NEAR(std::log2(ratio), p.order, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Orders, Integrators,
                         testing::Values(OrderOf{"explicit_euler", 1, 5e-4}, OrderOf{"semi_implicit_euler", 1, 5e-4},
                                         OrderOf{"implicit_euler", 1, 5e-4}, OrderOf{"midpoint", 2, 1e-3},
                                         OrderOf{"runge_kutta_4", 4, 2e-3},
                                         OrderOf{{"dormand_prince", {{"tolerance", 1}}}, 5, 16e-3}),
                         [](const auto& test) { return test.param.integrator.name; });

class InLanes : public testing::TestWithParam<const char*> {};

TEST_P(InLanes, EqualScalarBitForBit) {
  const std::string integrator = GetParam();
  FlyingRobots together(4, integrator, 1e-3, 4);
  for (unsigned i = 0; i < 4; ++i) together.toss(i, i);
  together.run(0.2);
  for (unsigned i = 0; i < 4; ++i) {
    FlyingRobots alone(1, integrator, 1e-3);
    alone.toss(0, i);
    alone.run(0.2);
    const Pose a = together.linked().handle(together.robots()[i], kBasePose).get();
    const Pose b = alone.linked().handle(alone.robots()[0], kBasePose).get();
    EXPECT_EQ(std::memcmp(&a, &b, sizeof(Pose)), 0) << i;
    const auto q = together.linked().handle(together.robots()[i], kJointPosition, subset::kJoints);
    const auto p = alone.linked().handle(alone.robots()[0], kJointPosition, subset::kJoints);
    for (int j = 0; j < q.size(); ++j) EXPECT_EQ(q.get(j), p.get(j)) << i << " " << j;
  }
}

INSTANTIATE_TEST_SUITE_P(MultibodyDynamics, InLanes, testing::Values("implicit_euler", "runge_kutta_4"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace murosimf::motion
