// Multibody dynamics without ground: what free flight conserves.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "book/page.h"
#include "modules/flying_robots.h"

namespace murosimf::motion {
namespace {

TEST(MultibodyDynamics, CentreOfMassFliesAParabolaAndMomentumStaysWhileLimbsSwing) {
  constexpr double kTime = 0.2;
  FlyingRobots flight(1, "runge_kutta_4", 1e-4);
  flight.toss(0, 3);
  const auto before = flight.mechanics(0);
  book::Page page({book::Chapter::kFlight,
                   "The centre of mass flies a parabola while all limbs swing",
                   R"(z = z_0 + \frac{p_z}{m} t - \frac{g}{2} t^2)",
                   "Law of the centre of mass, KS21 with 21 joints",
                   {{"p_z", "momentum upwards at first", "kg m/s"}, {"m", "mass", "kg"}},
                   {"time $t$", "s"},
                   {"height of the centre of mass $z$", "m"}});
  const auto flown = [&](double t) {
    return before.centre + before.linear * (t / before.mass) + Vector3{0, 0, -0.5 * 9.81 * t * t};
  };
  page.curve(0, kTime, [&](double t) { return flown(t).z; });
  for (int i = 1; i <= 10; ++i) {
    flight.run(kTime / 10);
    const double t = i * kTime / 10;
    EXPECT_TRUE(page.near(t, flight.mechanics(0).centre.z, flown(t).z, 1e-10));
  }
  const auto after = flight.mechanics(0);
  EXPECT_LT(norm(after.centre - flown(kTime)), 1e-10);
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
  book::Page page({book::Chapter::kIntegrators,
                   "The error of each integrator falls with the order of its method",
                   R"(\epsilon(h/2) = 2^{-p} \epsilon(h))",
                   "[Hairer, Norsett, Wanner 1993]; theory: from the error at the larger step",
                   {{"\\epsilon", "distance of base and joints of a tossed KS21 from a much finer run", ""},
                    {"p", "order of the method", ""}},
                   {"step $h$", "s", true},
                   {"error $\\epsilon$", "", true}});
  const double coarse = errorOf(p.integrator, p.step), fine = errorOf(p.integrator, p.step / 2);
  const auto falling = [&](double h) { return coarse * std::pow(h / p.step, p.order); };
  page.curve(p.step / 2, p.step, falling);
  EXPECT_TRUE(page.near(p.step / 2, fine, falling(p.step / 2), falling(p.step / 2) * (std::exp2(0.15) - 1)));
  EXPECT_NEAR(std::log2(coarse / fine), p.order, 0.15);
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
