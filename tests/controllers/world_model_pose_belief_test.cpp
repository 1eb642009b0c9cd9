// One hypothesis of the self-localisation against closed forms of linear estimation.

#include <gtest/gtest.h>

#include "world_model_arena.h"

namespace murosimf::controllers {
namespace {

constexpr Measurement alongX(double measured, double expected, double variance) {
  return {{1, 0, 0}, measured - expected, variance};
}

TEST(PoseBelief, VarianceAfterEqualMeasurementsIsThatOfTheirMean) {
  PoseBelief belief = PoseBelief::at({0, 0, 0}, 2.0, 1.0);
  const double r = 0.09;
  for (int n = 1; n <= 50; ++n) {
    belief.correct(alongX(0.7, belief.mean.x, r));
    EXPECT_NEAR(belief.covariance[0][0], 1 / (1 / 4.0 + n / r), 1e-12);  // information adds up
  }
  EXPECT_NEAR(belief.mean.x, 0.7 * (50 / r) / (1 / 4.0 + 50 / r), 1e-12);
  EXPECT_EQ(belief.covariance[1][1], 4.0);  // what was not measured stays
}

TEST(PoseBelief, HeadingErrorTurnsIntoSidewaysErrorOnAStraightWay) {
  PoseBelief belief = PoseBelief::at({0, 0, 0}, 0, 0.1);
  const PoseBelief still = [] {
    PoseBelief other = PoseBelief::at({0, 0, 0}, 0, 0);
    for (int i = 0; i < 100; ++i) other.move({0.01, 0, 0});
    return other;
  }();
  for (int i = 0; i < 100; ++i) belief.move({0.01, 0, 0});
  EXPECT_NEAR(belief.mean.x, 1.0, 1e-12);
  // Beyond the odometry's own noise: y = 1 m * heading.
  EXPECT_NEAR(belief.covariance[1][1] - still.covariance[1][1], 0.01, 1e-12);
  EXPECT_NEAR(belief.covariance[1][2] - still.covariance[1][2], 0.01, 1e-12);
  EXPECT_NEAR(belief.covariance[0][0], still.covariance[0][0], 1e-12);
}

TEST(PoseBelief, RowsOfALandmarkAreTheDerivativesOfItsBearingAndDistance) {
  const Point landmark{2.25, 0.8};
  const LandmarkSight sight{LandmarkKind::kPost, LandmarkColour::kYellow, 0.3, 2.0, 4e-4, 0.04};
  const PlanarPose pose{-0.4, 0.5, 0.7};
  const PolarInnovation here = PoseBelief::at(pose, 0.1, 0.1).compare(sight, landmark);
  const double h = 1e-6;
  for (std::size_t i = 0; i < 3; ++i) {
    PlanarPose moved = pose;
    (i == 0 ? moved.x : i == 1 ? moved.y : moved.heading) += h;
    const PolarInnovation there = PoseBelief::at(moved, 0.1, 0.1).compare(sight, landmark);
    EXPECT_NEAR(-(there.bearing.innovation - here.bearing.innovation) / h, here.bearing.row[i], 1e-5);
    EXPECT_NEAR(-(there.distance.innovation - here.distance.innovation) / h, here.distance.row[i], 1e-5);
  }
}

TEST(PoseBelief, SightOfALandmarkInPlaceHasNoErrorAndTheDensityOfANormalDistribution) {
  const PoseBelief belief = PoseBelief::at({1, 0.2, 0.1}, 0, 0);
  const Point landmark{2, 0.2};
  const LandmarkSight sight{LandmarkKind::kPole, LandmarkColour::kBlue, -0.1, 1.0, 0.0004, 0.01};
  const PolarInnovation innovation = belief.compare(sight, landmark);
  EXPECT_NEAR(innovation.squared_error, 0, 1e-20);
  EXPECT_NEAR(innovation.density, 1 / (2 * kPi * 0.02 * 0.1), 1e-9);
}

TEST(PoseBelief, CovarianceStaysPositiveDefiniteThroughAThousandSights) {
  Arena arena("red", 3);
  PoseBelief belief = PoseBelief::at(arena.truth, 1, 1);
  const Point landmark{2.25, 0.8};
  for (int i = 0; i < 1000; ++i) {
    belief.move(arena.walk());
    const Point p_R = transformedBack(arena.truth, landmark);
    const LandmarkSight sight{LandmarkKind::kPost, LandmarkColour::kYellow, direction(p_R), norm(p_R), 1e-6, 1e-6};
    belief.correct(belief.compare(sight, landmark));
    const auto& P = belief.covariance;
    const double minor = P[0][0] * P[1][1] - P[0][1] * P[1][0];
    const double determinant = P[0][0] * (P[1][1] * P[2][2] - P[1][2] * P[2][1]) -
                               P[0][1] * (P[1][0] * P[2][2] - P[1][2] * P[2][0]) +
                               P[0][2] * (P[1][0] * P[2][1] - P[1][1] * P[2][0]);
    ASSERT_GT(P[0][0], 0);
    ASSERT_GT(minor, 0);
    ASSERT_GT(determinant, 0);
  }
}

TEST(PosesFromPair, TwoExactSightsTellThePose) {
  FieldMap map;
  map.start(robotOfTeam("red"));
  const PlanarPose truth{-0.7, 0.4, 0.3};
  const auto seen = [&](LandmarkKind kind, LandmarkColour colour, const Point& p_F) {
    const Point p_R = transformedBack(truth, p_F);
    return LandmarkSight{kind, colour, direction(p_R), norm(p_R), 4e-4, 4e-4};
  };
  const LandmarkSight post = seen(LandmarkKind::kPost, LandmarkColour::kYellow, {2.25, 0.8});
  const LandmarkSight pole = seen(LandmarkKind::kPole, LandmarkColour::kYellow, {0, 1.5});
  const PoseProposals proposals = posesFromPair(map, post, pole);
  ASSERT_EQ(proposals.count, 1U);
  EXPECT_NEAR(proposals.beliefs[0].mean.x, truth.x, 1e-9);
  EXPECT_NEAR(proposals.beliefs[0].mean.y, truth.y, 1e-9);
  EXPECT_NEAR(proposals.beliefs[0].mean.heading, truth.heading, 1e-9);
}

TEST(PosesFromPair, TheTwoPostsOfAGoalTellOnePoseInTheField) {
  FieldMap map;
  map.start(robotOfTeam("red"));
  // Standing at (0.25, 0.3), looking at the yellow goal: left post 0.5 m to the left, right post 1.1 m to the right.
  const auto seen = [](double x, double y) {
    const Point p{x, y};
    return LandmarkSight{LandmarkKind::kPost, LandmarkColour::kYellow, direction(p), norm(p), 4e-4, 4e-4};
  };
  const PoseProposals proposals = posesFromPair(map, seen(2, 0.5), seen(2, -1.1));
  ASSERT_EQ(proposals.count, 1U);  // the exchanged names would put the robot behind the goal
  EXPECT_NEAR(proposals.beliefs[0].mean.x, 0.25, 1e-9);
  EXPECT_NEAR(proposals.beliefs[0].mean.y, 0.3, 1e-9);
  EXPECT_NEAR(proposals.beliefs[0].mean.heading, 0, 1e-9);
}

TEST(PosesFromOne, FourHeadingsOfOneSightIncludeTheTrueOne) {
  FieldMap map;
  map.start(robotOfTeam("red"));
  const PlanarPose truth{0.2, 0.1, 0.9};
  const Point p_R = transformedBack(truth, {0, 1.5});
  const LandmarkSight pole{LandmarkKind::kPole, LandmarkColour::kYellow, direction(p_R), norm(p_R), 4e-4, 4e-3};
  const PoseProposals proposals = posesFromOne(map, pole, -0.9);  // a line along x lies at -heading in R
  int right = 0;
  for (const PoseBelief& belief : std::span(proposals.beliefs).first(proposals.count)) {
    EXPECT_NEAR(norm(Point{belief.mean.x, belief.mean.y - 1.5}), norm(p_R), 1e-12);
    right +=
        norm(Point{belief.mean.x - 0.2, belief.mean.y - 0.1}) < 1e-9 && std::fabs(belief.mean.heading - 0.9) < 1e-9;
  }
  EXPECT_EQ(right, 1);
}

TEST(LineSights, LinesAtRightAnglesHaveOneDirection) {
  std::vector<LinePercept> percepts;
  for (int i = 0; i < 8; ++i) percepts.push_back({1, 0.1 * i, 0.3 + 0.5 * kPi * i});
  const LineSights lines(percepts);
  ASSERT_TRUE(lines.haveDirection());
  EXPECT_NEAR(lines.direction(), 0.3, 1e-9);
  EXPECT_NEAR(lines.dependence(), 8.0 / 3, 1e-12);
}

TEST(LineSights, PointsOfACircleHaveNoDirection) {
  std::vector<LinePercept> percepts;
  for (int i = 0; i < 8; ++i) percepts.push_back({1, 0.1 * i, 0.125 * kPi * i / 2});
  EXPECT_FALSE(LineSights(percepts).haveDirection());
}

}  // namespace
}  // namespace murosimf::controllers
