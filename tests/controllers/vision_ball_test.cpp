/// What is a ball, and what is not.

#include <gtest/gtest.h>

#include "controllers/vision_trials.h"

namespace murosimf::test {
namespace {

/// A robot at the origin that looks at the middle of an otherwise bare field.
struct Watch {
  View view;
  controllers::Percepts percepts;

  explicit Watch(int camera = 0, double pan = 0, double tilt = 0.3) {
    view.scene.field = smallField();
    view.camera = camera;
    view.robot = {-1.2, 0.4, -0.3};
    view.X_RC = camera == 0 ? headCameraPose(pan, tilt) : chestCameraPose();
  }
  Vector3 place(double x, double y) const { return toPose(view.robot) * Vector3{x, y, 0}; }
  void ball(double x, double y, double height = 0.07, double radius = 0.07) {
    const Vector3 p = place(x, y);
    addBall(view.scene, p.x, p.y, height, radius);
  }
  const std::vector<controllers::BallPercept>& look() {
    std::vector<std::uint8_t> rgb;
    synthesiser()(view, rgb);
    controllers::Vision vision;
    vision.start(observer());
    test::look(vision, view, rgb, percepts);
    return percepts.balls;
  }
};

TEST(VisionBall, IsWhereItLies) {
  for (const double x : {0.4, 0.8, 1.6, 2.4}) {
    Watch watch(0, 0, x < 0.6 ? 0.7 : 0.25);
    watch.ball(x, 0.1 * x);
    const auto& balls = watch.look();
    ASSERT_EQ(balls.size(), 1U) << x;
    EXPECT_NEAR(balls[0].x, x, 0.01 * x + 0.003);
    EXPECT_NEAR(balls[0].y, 0.1 * x, 0.004);
    EXPECT_LT(balls[0].deviation, 0.08 * x);
  }
}

TEST(VisionBall, DrawnCircleIsTheBallsOutline) {
  Watch watch;
  watch.ball(1.5, 0.2);
  ASSERT_EQ(watch.look().size(), 1U);
  const client::Percept& drawn = watch.percepts.drawn.at(0);
  ASSERT_EQ(drawn.kind, client::Percept::Kind::kBall);
  const Vector3 p_C = applyInverse(watch.view.X_RC, {1.5, 0.2, 0.07});
  const controllers::PixelPoint centre = controllers::toPixel(headCamera(), {p_C.x / p_C.z, p_C.y / p_C.z});
  EXPECT_NEAR(drawn.u, centre.u, 0.6);
  EXPECT_NEAR(drawn.v, centre.v, 0.6);
  EXPECT_NEAR(drawn.radius, headCamera().fx * 0.07 / p_C.z, 1.0);
}

TEST(VisionBall, IsFoundAtTheBentBorderOfAWideLens) {
  Watch watch(1);
  watch.ball(0.8, 0.85);  // 47 degrees to the left
  const auto& balls = watch.look();
  ASSERT_EQ(balls.size(), 1U);
  EXPECT_NEAR(balls[0].x, 0.8, 0.02);
  EXPECT_NEAR(balls[0].y, 0.85, 0.02);
}

TEST(VisionBall, HalfBehindAFootIsMeasuredByWhatIsSeen) {
  Watch watch;
  watch.ball(1.2, 0);
  Solid foot{
      Solid::Kind::kBox, watch.place(1.08, 0.075), 0, {0.03, 0.05, 0.1}, watch.view.robot.heading, {25, 25, 25}, 9};
  foot.centre.z = 0.1;
  watch.view.scene.solids.push_back(foot);
  const auto& balls = watch.look();
  ASSERT_EQ(balls.size(), 1U);
  EXPECT_NEAR(balls[0].x, 1.2, 0.06);
  EXPECT_NEAR(balls[0].y, 0, 0.02);
}

TEST(VisionBall, CutByThePictureIsMeasuredByWhatIsSeen) {
  Watch watch(0, 0.35, 0.3);
  watch.ball(1.0, -0.2);
  const auto& balls = watch.look();
  ASSERT_EQ(balls.size(), 1U);
  ASSERT_GT(watch.percepts.drawn[0].u + watch.percepts.drawn[0].radius, 640) << "the test wants a cut ball";
  EXPECT_NEAR(balls[0].x, 1.0, 0.05);
  EXPECT_NEAR(balls[0].y, -0.2, 0.02);
}

TEST(VisionBall, OfAnotherSizeIsNone) {
  for (const double radius : {0.03, 0.13}) {
    Watch watch;
    watch.ball(1.3, 0, radius, radius);
    EXPECT_TRUE(watch.look().empty()) << radius;
  }
}

TEST(VisionBall, InTheAirIsNone) {
  for (const double height : {0.45, 0.8}) {
    Watch watch(0, 0, 0);
    watch.ball(1.5, 0, height);
    EXPECT_TRUE(watch.look().empty()) << height;
  }
}

TEST(VisionBall, OrangeBoxIsNone) {
  Watch watch;
  Solid box{Solid::Kind::kBox, watch.place(1.3, 0), 0, {0.06, 0.06, 0.06}, 0.4, {240, 110, 20}, 9};
  box.centre.z = 0.06;
  watch.view.scene.solids.push_back(box);
  EXPECT_TRUE(watch.look().empty());
}

TEST(VisionBall, BesideAYellowPostIsNotLostInIt) {
  Watch watch(0, 0, 0.2);
  const Vector3 p = watch.place(1.9, 0.02);
  watch.view.scene.solids.push_back(
      {Solid::Kind::kCylinder, {p.x, p.y, 0.45}, 0.05, {0, 0, 0.45}, 0, {230, 200, 30}, 9});
  watch.ball(1.5, 0);
  const auto& balls = watch.look();
  ASSERT_EQ(balls.size(), 1U);
  EXPECT_NEAR(balls[0].x, 1.5, 0.03);
}

}  // namespace
}  // namespace murosimf::test
