/// Posts and poles one at a time: what is measured when part of them is out of sight.

#include <gtest/gtest.h>

#include "controllers/vision_trials.h"

namespace murosimf::test {
namespace {

using controllers::LandmarkColour;

controllers::Percepts lookFrom(const PlanarPose& robot, double pan, double tilt, int camera = 0,
                               const std::vector<Solid>& more = {}) {
  View view;
  view.scene = emptyField();
  for (const Solid& s : more) view.scene.solids.push_back(s);
  view.robot = robot;
  view.camera = camera;
  view.X_RC = camera == 0 ? headCameraPose(pan, tilt) : chestCameraPose();
  std::vector<std::uint8_t> rgb;
  synthesiser()(view, rgb);
  controllers::Vision vision;
  vision.start(observer());
  controllers::Percepts percepts;
  look(vision, view, rgb, percepts);
  return percepts;
}

TEST(VisionLandmarks, BothPostsOfAGoalAndNothingElseOfIt) {
  const controllers::Percepts p = lookFrom({0.3, 0.2, 0}, 0, 0);
  ASSERT_EQ(p.posts.size(), 2U);
  EXPECT_TRUE(p.poles.empty());
  for (const auto& post : p.posts) {
    const double y = post.bearing > 0 ? 0.8 - 0.2 : -0.8 - 0.2, x = 2.25 - 0.3;
    EXPECT_EQ(post.colour, LandmarkColour::kYellow);
    EXPECT_NEAR(post.bearing, atan2(y, x), 0.003);
    EXPECT_NEAR(post.distance, sqrt(x * x + y * y), 0.04);
    EXPECT_TRUE(post.foot_seen);
  }
}

TEST(VisionLandmarks, PostWhoseFootIsOutOfThePictureIsMeasuredByItsWidth) {
  const controllers::Percepts p = lookFrom({1.0, -0.6, 0}, 0, -0.45);
  ASSERT_EQ(p.posts.size(), 1U);
  EXPECT_FALSE(p.posts[0].foot_seen);
  EXPECT_NEAR(p.posts[0].distance, sqrt(1.25 * 1.25 + 0.2 * 0.2), 0.06);
}

TEST(VisionLandmarks, PoleIsNamedByItsTopSegmentEvenWhenThatIsCutOff) {
  const PlanarPose robot{0, -0.1, kPi / 2};
  for (const double tilt : {0.0, 0.42}) {  // whole; upper segment out of the picture
    const controllers::Percepts p = lookFrom(robot, 0, tilt);
    ASSERT_EQ(p.poles.size(), 1U) << tilt;
    EXPECT_EQ(p.poles[0].colour, LandmarkColour::kYellow) << tilt;
    EXPECT_NEAR(p.poles[0].distance, 1.6, 0.04) << tilt;
    EXPECT_NEAR(p.poles[0].bearing, 0, 0.004) << tilt;
  }
}

TEST(VisionLandmarks, PoleWhoseFootIsCoveredIsMeasuredByItsWidth) {
  const Solid box{Solid::Kind::kBox, {0, 1.0, 0.06}, 0, {0.2, 0.02, 0.06}, 0, {60, 60, 65}, 9};
  const controllers::Percepts p = lookFrom({0, -0.1, kPi / 2}, 0, 0.1, 0, {box});
  ASSERT_EQ(p.poles.size(), 1U);
  EXPECT_FALSE(p.poles[0].foot_seen);
  EXPECT_NEAR(p.poles[0].distance, 1.6, 0.05);
}

TEST(VisionLandmarks, HalfCoveredPoleWithoutFootIsNotReportedTooFarAway) {
  const Solid screen{Solid::Kind::kBox, {0.14, 0.6, 0.3}, 0, {0.14, 0.02, 0.3}, 0, {60, 60, 65}, 9};
  const Solid sill{Solid::Kind::kBox, {0, 0.65, 0.06}, 0, {0.3, 0.02, 0.06}, 0, {60, 60, 65}, 9};
  const controllers::Percepts p = lookFrom({0, -0.1, kPi / 2}, 0, 0.1, 0, {screen, sill});
  for (const auto& pole : p.poles) EXPECT_NEAR(pole.distance, 1.6, 0.25);
}

TEST(VisionLandmarks, WideLensBendsPostsAndFindsThemAllTheSame) {
  const controllers::Percepts p = lookFrom({1.1, 0, 0}, 0, 0, 1);
  ASSERT_EQ(p.posts.size(), 2U);
  for (const auto& post : p.posts) {
    EXPECT_NEAR(abs(post.bearing), atan2(0.8, 1.15), 0.01);
    EXPECT_NEAR(post.distance, sqrt(0.8 * 0.8 + 1.15 * 1.15), 0.06);
  }
}

TEST(VisionLandmarks, YellowMatOnTheGroundIsNoPost) {
  const Solid mat{Solid::Kind::kBox, {1.2, 0.1, 0.005}, 0, {0.5, 0.05, 0.005}, 0, {230, 200, 30}, 9};
  const controllers::Percepts p = lookFrom({-0.2, 0.1, 0}, 0, 0.3, 0, {mat});
  for (const auto& post : p.posts) EXPECT_GT(abs(post.bearing), 0.1);
}

}  // namespace
}  // namespace murosimf::test
