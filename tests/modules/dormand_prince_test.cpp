// Steps of the length that a wanted accuracy allows, each robot by itself.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "book/page.h"
#include "modules/dynamic_world.h"
#include "modules/flying_robots.h"
#include "murosimf/modules/integration/dormand_prince.h"

namespace murosimf::motion {
namespace {

Method dormandPrince(double tolerance) { return {"dormand_prince", {{"tolerance", tolerance}}}; }

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// A robot tossed and followed for 0.4 s in frames of 0.1 s, which leave its steps their length.
struct Toss {
  std::vector<double> positions;
  double evaluations = 0, substeps = 0, estimated = 0;  ///< sums over all frames

  explicit Toss(double tolerance) {
    FlyingRobots flight(1, dormandPrince(tolerance), 0.1);
    flight.toss(0, 3);
    for (int i = 0; i < 4; ++i) {
      flight.run(0.1);
      EXPECT_EQ(flight.get(0, kIntegrationFault), 0);
      EXPECT_GE(flight.get(0, kForceEvaluations), 1 + 6 * flight.get(0, kSubsteps));
      evaluations += flight.get(0, kForceEvaluations), substeps += flight.get(0, kSubsteps);
      estimated += flight.get(0, kIntegrationError);
    }
    positions = flight.positions(0);
  }
  double error() const {
    static const Toss reference(1e-14);
    return distance(positions, reference.positions);
  }
};

TEST(DormandPrince, ErrorIsProportionalToTheToleranceAndCostGrowsWithItsFifthRoot) {
  const Toss coarse(1e-8), middle(1e-10), fine(1e-12);
  book::Page page(
      {book::Chapter::kIntegrators,
       "The error of Dormand-Prince is proportional to the tolerance, its cost grows with the fifth root",
       R"(\log_{10}\frac{\epsilon(100 \tau)}{\epsilon(\tau)} = 2, \quad \log_{10}\frac{n(\tau/100)}{n(\tau)} = \frac{2}{5})",
       "[Dormand & Prince 1980], [Hairer, Norsett, Wanner 1993]",
       {{"\\epsilon", "error after 0.4 s of a tossed KS21", ""}, {"n", "evaluations of forces", ""}},
       {"tolerance $\\tau$", "", true},
       {"powers of ten", ""}});
  EXPECT_TRUE(page.series("error").near(1e-10, std::log10(coarse.error() / middle.error()), 2, 0.3));
  EXPECT_TRUE(page.near(1e-12, std::log10(middle.error() / fine.error()), 2, 0.3));
  EXPECT_TRUE(page.series("cost").near(1e-12, std::log10(fine.evaluations / middle.evaluations), 2.0 / 5, 0.05));
  EXPECT_LT(fine.error(), 1e-12);
}

TEST(DormandPrince, EstimatesItsErrorOnTheSafeSide) {
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    const Toss toss(tolerance);
    EXPECT_GT(toss.estimated, toss.error());  // of order 4, while the step is of order 5
    EXPECT_LT(toss.estimated, 100 * toss.error());
    EXPECT_LE(toss.estimated, tolerance * toss.substeps);
  }
}

TEST(DormandPrince, RobotsInLanesKeepTheBitsOfTheirOwnRunThoughEachHasStepsOfItsOwn) {
  for (const int lanes : {4, 8}) {
    FlyingRobots together(8, dormandPrince(1e-9), 0.01, lanes);
    for (unsigned i = 0; i < 8; ++i) together.toss(i, i);
    together.run(0.1);
    double fewest = 1e9, most = 0;
    for (unsigned i = 0; i < 8; ++i) {
      FlyingRobots alone(1, dormandPrince(1e-9), 0.01);
      alone.toss(0, i);
      alone.run(0.1);
      EXPECT_EQ(together.memory(i), alone.memory(0)) << lanes << " " << i;
      fewest = min(fewest, alone.get(0, kSubsteps)), most = max(most, alone.get(0, kSubsteps));
    }
    EXPECT_LT(fewest, most);
  }
}

TEST(DormandPrince, ARobotWithoutNumbersNeitherHangsNorDisturbsOthers) {
  FlyingRobots together(4, dormandPrince(1e-9), 0.01, 4);
  for (unsigned i = 0; i < 4; ++i) together.toss(i, i);
  together.run(0.05);
  together.linked()
      .handle(together.robots()[2], kJointVelocity, subset::kJoints)
      .set(std::numeric_limits<double>::quiet_NaN(), 5);
  together.run(0.05);
  EXPECT_EQ(together.get(2, kIntegrationFault), 1);
  EXPECT_LT(together.get(2, kForceEvaluations), 100);
  for (const unsigned i : {0U, 1U, 3U}) {
    FlyingRobots alone(1, dormandPrince(1e-9), 0.01);
    alone.toss(0, i);
    alone.run(0.1);
    EXPECT_EQ(together.memory(i), alone.memory(0)) << i;
  }
}

TEST(DormandPrince, ARobotThatNeedsTooManyStepsStopsAsFaultyWhereItIs) {
  FlyingRobots flight(1, {"dormand_prince", {{"tolerance", 1e-10}, {"most_rounds", 3}}}, 0.02);
  flight.toss(0, 3);
  flight.run(0.02);
  EXPECT_EQ(flight.get(0, kIntegrationFault), 1);
  EXPECT_LE(flight.get(0, kSubsteps), 3);
  for (const double x : flight.positions(0)) EXPECT_TRUE(std::isfinite(x));
}

TEST(Integrators, RobotsOfOneWorldWithDifferentOnesKeepTheBitsOfTheirOwnRuns) {
  const std::vector<Method> all{"implicit_euler", "dormand_prince", "midpoint",
                                "runge_kutta_4",  "explicit_euler", "semi_implicit_euler"};
  FlyingRobots together(all, 1e-3, 0);
  for (unsigned i = 0; i < all.size(); ++i) together.toss(i, i);
  together.run(0.1);
  for (unsigned i = 0; i < all.size(); ++i) {
    FlyingRobots alone(1, all[i], 1e-3);
    alone.toss(0, i);
    alone.run(0.1);
    EXPECT_EQ(together.memory(i), alone.memory(0)) << all[i].name;
  }
}

/// Where KS21 stands after half a second of stepping forward on turf.
Vector3 walked(const std::string& integrator, double frame) {
  constexpr double kControl = 0.02;
  DynamicWorld world(frame);
  const ObjectId robot = world.add("robot", ks21(), gait(0, {}, 0));
  world.link(multibody("hunt_crossley_contact", integrator));
  for (double t = 0; t < 0.5; t += kControl) {
    world.command(robot, gait(t / 0.52, {0.1, 0, 0}, t));
    world.run(kControl);
  }
  return world.base(robot).translation;
}

TEST(DormandPrince, WalksTheSameWayInFramesOfAnyLengthWhichFixedStepsComeTo) {
  const Vector3 way = walked("dormand_prince", 1e-3);
  EXPECT_LT(norm(walked("dormand_prince", 0.01) - way), 1e-6);
  const double coarse = norm(walked("implicit_euler", 1e-3) - way), fine = norm(walked("implicit_euler", 1e-4) - way);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / 5);  // of order 1
}

TEST(DormandPrince, ItsPathMeetsTheConditionsOfOrderFourInsideTheStepAndBeyondIt) {
  const auto sum = [](const StageWeights<double>& w, const double(&values)[kDormandPrinceStages]) {
    double result = 0;
    for (int i = 0; i < kDormandPrinceStages; ++i) result += w.of[i] * values[i];
    return result;
  };
  // 1, c, c^2, A c, c^3, c A c, A c^2, A A c [Hairer, Norsett, Wanner 1993, II.2]
  double c[8][kDormandPrinceStages];
  for (int i = 0; i < kDormandPrinceStages; ++i) {
    const StageWeights<double> a = stageWeights<double>(i);
    c[0][i] = 1, c[1][i] = kStageShare[i], c[2][i] = c[1][i] * c[1][i], c[4][i] = c[2][i] * c[1][i];
    EXPECT_NEAR(sum(a, c[0]), c[1][i], 1e-14);
    for (const auto& [row, of] : {std::pair(3, 1), std::pair(6, 2), std::pair(7, 3)}) {
      c[row][i] = 0;
      for (int j = 0; j < i; ++j) c[row][i] += a.of[j] * c[of][j];
    }
    c[5][i] = c[1][i] * c[3][i];
  }
  constexpr int kOrder[] = {1, 2, 3, 3, 4, 4, 4, 4};
  constexpr double kFactor[] = {1, 2, 3, 6, 4, 8, 12, 24};
  for (const double theta : {0.1, 0.5, 0.9, 1.0, 1.1, 1.2}) {
    for (int k = 0; k < 8; ++k) {
      EXPECT_NEAR(sum(pathWeights(theta), c[k]), std::pow(theta, kOrder[k]) / kFactor[k], 1e-13) << theta << " " << k;
    }
  }
  const StageWeights<double> end = pathWeights(1.0), step = stageWeights<double>(kDormandPrinceStages - 1);
  for (int i = 0; i < kDormandPrinceStages; ++i) EXPECT_EQ(end.of[i], step.of[i]);
}

}  // namespace
}  // namespace murosimf::motion
