// The ball model: Kalman filter against closed forms, and the guard against false sights.

#include <gtest/gtest.h>

#include <limits>

#include "world_model_arena.h"

namespace murosimf::controllers {
namespace {

constexpr double kLook = 0.05;  // time between pictures [s]

Percepts sightAt(const Point& p, double deviation = 0.03) {
  Percepts percepts;
  percepts.balls.push_back({p.x, p.y, deviation});
  return percepts;
}

/// A model that has seen a resting ball at p for a second.
BallModel settledAt(const Point& p) {
  BallModel ball;
  ball.start({});
  for (int i = 0; i < 20; ++i) ball.move({}, kLook), ball.observe(sightAt(p));
  return ball;
}

TEST(RollBall, LosesSpeedAndRestsWhereTheClosedFormSays) {
  Point p{0.1, -0.2}, v{0.8, 0.6};  // 1 m/s, towards (0.8, 0.6)
  for (int i = 0; i < 100; ++i) rollBall(p, v, 0.01);
  EXPECT_NEAR(norm(v), 1 - BallFilter::kRollingDeceleration, 1e-12);
  EXPECT_NEAR(norm(p - Point{0.1, -0.2}), 1 - 0.5 * BallFilter::kRollingDeceleration, 1e-12);
  for (int i = 0; i < 400; ++i) rollBall(p, v, 0.01);
  EXPECT_EQ(norm(v), 0);
  const double way = 1 / (2 * BallFilter::kRollingDeceleration);  // v^2 / (2 a)
  EXPECT_NEAR(p.x, 0.1 + 0.8 * way, 1e-12);
  EXPECT_NEAR(p.y, -0.2 + 0.6 * way, 1e-12);
}

TEST(BallFilter, SettlesAtTheAlphaBetaFilterForEqualSteps) {
  // [Kalata 1984]: index L = sigma dt^2 / sigma_r, r = (4 + L - sqrt(8 L + L^2)) / 4, alpha = 1 - r^2,
  // beta = 2 (2 - alpha) - 4 sqrt(1 - alpha); variance of the corrected position alpha sigma_r^2.
  const double deviation = 0.02, dt = 0.1;
  BallFilter filter;
  const BallSight sight{{1, 0}, deviation * deviation, deviation * deviation};
  filter.begin(sight, {0, 0}, 0.25);
  for (int i = 0; i < 400; ++i) filter.roll(dt), filter.correct(sight);
  const double L = BallFilter::kAcceleration * dt * dt / deviation;
  const double r = (4 + L - sqrt(8 * L + L * L)) / 4, alpha = 1 - r * r;
  EXPECT_NEAR(filter.covariance[0][0], alpha * deviation * deviation, 1e-9);
  EXPECT_NEAR(filter.covariance[1][1], alpha * deviation * deviation, 1e-9);
  const double beta = 2 * (2 - alpha) - 4 * sqrt(1 - alpha);
  EXPECT_NEAR(filter.covariance[0][2], beta / dt * deviation * deviation, 1e-9);
  filter.correct({{1.01, 0}, deviation * deviation, deviation * deviation});  // without a step: same innovation again
  EXPECT_GT(filter.position().x, 1.0);
}

TEST(BallFilter, TurningTheFrameKeepsTheSizeOfTheCovariance) {
  BallFilter filter;
  filter.begin({{1, 0.5}, 0.04, 0.0025}, {0.3, -0.1}, 0.09);
  filter.roll(0.1);
  const auto trace = [](const BallFilter& f) { return f.covariance[0][0] + f.covariance[1][1]; };
  const double before = trace(filter);
  BallFilter turned = filter;
  for (int i = 0; i < 4; ++i) turned.turn({0, 0, kPi / 2});
  const double noise = trace(turned) - before;
  EXPECT_NEAR(turned.position().x, filter.position().x, 1e-12);
  EXPECT_NEAR(turned.velocity().y, filter.velocity().y, 1e-12);
  EXPECT_NEAR(turned.covariance[0][2], filter.covariance[0][2], 1e-12);
  EXPECT_NEAR(turned.covariance[0][1], filter.covariance[0][1], 1e-12);
  EXPECT_GT(noise, 0);
  EXPECT_LT(noise, 0.1);
}

TEST(BallModel, RestingBallStandsStillForAWalkingRobot) {
  Arena arena("red", 31);
  const Point ball_F{0.8, 0.3};
  BallModel ball;
  ball.start(arena.robot);
  std::vector<double> errors, speeds;
  for (int i = 0; i < 6000; ++i) {
    ball.move(arena.walk(), Arena::kStep);
    if (!arena.looks()) continue;
    const Point p_R = transformedBack(arena.truth, ball_F);
    if (arena.inView(p_R)) {
      const double distance = norm(p_R), seen = distance * (1 + arena.normal(0.08));
      const double bearing = direction(p_R) + arena.normal(0.02);
      ball.observe(sightAt({seen * cos(bearing), seen * sin(bearing)}, 0.01 + 0.08 * distance));
    }
    if (!ball.known() || i < 500) continue;
    const Vector3 p = ball.position(), v = ball.velocity();
    errors.push_back(norm(Point{p.x, p.y} - p_R) / norm(p_R));
    speeds.push_back(norm(v));
  }
  EXPECT_GT(errors.size(), 500U);
  EXPECT_LT(median(errors), 0.06);
  EXPECT_LT(median(speeds), 0.10);
}

TEST(BallModel, OneFalseSightDoesNotMoveTheBall) {
  BallModel ball = settledAt({1, 0.2});
  const Vector3 before = ball.position();
  ball.observe(sightAt({2.5, -1}));
  EXPECT_EQ(ball.position(), before);
  ball.move({}, kLook), ball.observe(sightAt({1, 0.2}));
  ball.move({}, kLook), ball.observe(sightAt({0.4, 1}));
  EXPECT_LT(norm(ball.position() - before), 0.01);
}

TEST(BallModel, ThreeSightsElsewhereMoveTheBallThere) {
  BallModel ball = settledAt({1, 0.2});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(ball.position().y, 0.2, 0.01) << i;
    ball.move({}, kLook), ball.observe(sightAt({0.5, -0.9}));
  }
  EXPECT_NEAR(ball.position().x, 0.5, 0.01);
  EXPECT_NEAR(ball.position().y, -0.9, 0.01);
}

TEST(BallModel, BallNeverSeenNeedsTwoSightsThatAgree) {
  BallModel ball;
  ball.start({});
  EXPECT_FALSE(ball.known());
  ball.observe(sightAt({1, 0}));
  EXPECT_FALSE(ball.known());
  ball.move({}, kLook), ball.observe(sightAt({-2, 2}));  // another invention
  EXPECT_FALSE(ball.known());
  ball.move({}, kLook), ball.observe(sightAt({-2, 2.02}));
  EXPECT_TRUE(ball.known());
  EXPECT_EQ(ball.age(), 0);
}

TEST(BallModel, VelocityOfAKickedBallIsKnownWithinAQuarterAfterSevenTenths) {
  Arena arena("red", 41);
  std::vector<double> errors;
  for (int kick = 0; kick < 40; ++kick) {
    const Point start{1.5, 0.2};
    BallModel ball = settledAt(start);
    Point p = start, v = 1.25 * Point{-0.9, arena.uniform(-0.4, 0.4)};
    for (int i = 0; i < 14; ++i) {
      rollBall(p, v, kLook);
      ball.move({}, kLook);
      const double distance = norm(p), seen = distance * (1 + arena.normal(0.04));
      const double bearing = direction(p) + arena.normal(0.02);
      ball.observe(sightAt({seen * cos(bearing), seen * sin(bearing)}, 0.01 + 0.04 * distance));
    }
    errors.push_back(norm(Point{ball.velocity().x, ball.velocity().y} - v) / norm(v));
  }
  EXPECT_LT(median(errors), 0.25);
  EXPECT_LT(quantile(errors, 0.9), 0.5);
}

TEST(BallModel, StaysWhereItIsWhileTheRobotTurnsAway) {
  BallModel ball = settledAt({1, 0});
  for (int i = 0; i < 100; ++i) ball.move({0, 0, 0.01}, 0.01);
  EXPECT_NEAR(ball.position().x, cos(1.0), 0.01);
  EXPECT_NEAR(ball.position().y, -sin(1.0), 0.01);
  EXPECT_NEAR(ball.age(), 1.0, 1e-12);
}

TEST(BallModel, RestingBallIsKnownSixSecondsAndARollingOneThree) {
  BallModel resting = settledAt({1, 0});
  for (int i = 0; i < 590; ++i) resting.move({}, 0.01);
  EXPECT_TRUE(resting.known());
  for (int i = 0; i < 20; ++i) resting.move({}, 0.01);
  EXPECT_FALSE(resting.known());

  BallModel rolling;
  rolling.start({});
  Point p{3, 0}, v{-2, 0};
  for (int i = 0; i < 20; ++i) {
    rollBall(p, v, kLook);
    rolling.move({}, kLook), rolling.observe(sightAt(p));
  }
  for (int i = 0; i < 290; ++i) rolling.move({}, 0.01);
  EXPECT_TRUE(rolling.known());
  for (int i = 0; i < 20; ++i) rolling.move({}, 0.01);
  EXPECT_FALSE(rolling.known());
}

TEST(BallModel, ForgottenBallIsUnknown) {
  BallModel ball = settledAt({1, 0});
  ball.forget();
  EXPECT_FALSE(ball.known());
  EXPECT_GT(ball.age(), 1e6);
}

TEST(BallModel, NonsenseNeverMakesANumberThatIsNone) {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300, 0};
  BallModel ball = settledAt({1, 0});
  for (const double a : bad)
    for (const double b : bad) {
      ball.observe(sightAt({a, b}, 0.1));
      ball.observe(sightAt({1, 0}, a));
      ball.move({a, b, 0}, 0.01);
      ball.move({0, 0, a}, b);
      const Vector3 p = ball.position(), v = ball.velocity();
      ASSERT_TRUE(std::isfinite(p.x + p.y + v.x + v.y + ball.age())) << a << " " << b;
    }
}

TEST(BallModel, ContinuesWithTheSameBitsAfterLoading) {
  BallModel original = settledAt({1, 0.3});
  original.move({0.01, 0, 0.02}, kLook), original.observe(sightAt({2, 1}));  // a rival is waiting
  client::StateArchive saved;
  original.archive(saved);
  BallModel restored;
  restored.start({});
  client::StateArchive loading(saved.bytes());
  restored.archive(loading);
  EXPECT_TRUE(loading.exhausted());
  Point p{2, 1}, v{-0.7, 0.1};
  for (int i = 0; i < 60; ++i) {
    rollBall(p, v, kLook);
    for (BallModel* ball : {&original, &restored}) {
      ball->move({0.002, 0.001, 0.01}, kLook);
      ball->observe(sightAt(p));
    }
    ASSERT_EQ(original.position(), restored.position());
    ASSERT_EQ(original.velocity(), restored.velocity());
    ASSERT_EQ(original.age(), restored.age());
  }
}

}  // namespace
}  // namespace murosimf::controllers
