// What a camera of level "oracle" sees, against closed forms: through the lens, to the borders, behind other things.

#include "murosimf/modules/camera/oracle_eye.h"

#include <gtest/gtest.h>

#include "modules/oracle_scene.h"
#include "murosimf/math/random.h"

namespace murosimf::testing {
namespace {

const Vector3 kFarAway{0, 50, 0.25};

ImagePoint placeOf(const CameraModel& lens, const Vector3& p_W) {
  return projectPoint(lens, applyInverse(oracleCameraPose(), p_W)).value();
}

TEST(OracleEye, ABallIsSeenWhereItsCentreFallsIntoThePicture) {
  const RandomStream random(1, "balls", 0);
  OracleScene scene({2, 0, kOracleBall}, kFarAway);
  OracleEye eye(oracleLens(), scene.targets, {}, {});
  int inside = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Vector3 ball{random.uniform(2 * i, 0.4, 4), random.uniform(2 * i + 1, -2, 2), kOracleBall};
    scene.scene.drawables[0].X_WS.translation = ball;
    const ImagePoint place = placeOf(oracleLens(), ball);
    const bool expected = place.u >= -0.5 && place.u < 639.5 && place.v >= -0.5 && place.v < 479.5;
    const auto all = eye.look(scene.scene, oracleCameraPose());
    const auto seen = ofTarget({all.begin(), all.end()}, 0);
    ASSERT_EQ(seen.size(), expected ? 1U : 0U) << ball.x << ' ' << ball.y << ": " << place.u << ' ' << place.v;
    inside += expected ? 1 : 0;
    EXPECT_LT(expected ? norm(seen[0].p_W - ball) : 0, 1e-12);
  }
  EXPECT_GT(inside, 100);
  EXPECT_LT(inside, 300);
}

TEST(OracleEye, NothingBehindTheCameraIsSeen) {
  const auto seen = OracleScene({-1, 0, kOracleBall}, {-1, 0.5, 0.25}).look();
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].target, 2) << "the line alone";
}

TEST(OracleEye, ARobotHidesTheBall) {
  ErrorsByKind seen_through;
  for (SightErrors& errors : seen_through) errors.occlusion = 0;
  const OracleScene behind({3, 0, kOracleBall}, {1.5, 0, 0.25}), beside({3, 0.6, kOracleBall}, {1.5, 0, 0.25});
  EXPECT_TRUE(ofTarget(behind.look(), 0).empty());
  EXPECT_EQ(ofTarget(behind.look(seen_through), 0).size(), 1U);
  EXPECT_EQ(ofTarget(beside.look(), 0).size(), 1U);
  // From the camera the box's edge at x = 1.4, y = .15 lies before y = .32 at x = 3.
  const OracleScene half({3, 0.30, kOracleBall}, {1.5, 0, 0.25});
  EXPECT_EQ(ofTarget(half.look(), 0).size(), 1U) << "half of it is enough";
  ASSERT_EQ(ofTarget(behind.look(), 1).size(), 1U);
  EXPECT_LT(norm(ofTarget(behind.look(), 1)[0].p_W - Vector3{1.5, 0, 0}), 1e-12) << "a robot is told by its foot";
}

TEST(OracleEye, FartherThanItsRangeNothingIsSeen) {
  ErrorsByKind errors;
  errors[kindIndex(SightKind::kBall)].range = 2.5;
  EXPECT_EQ(ofTarget(OracleScene({2.499, 0, kOracleBall}, kFarAway).look(errors), 0).size(), 1U);
  EXPECT_TRUE(ofTarget(OracleScene({2.501, 0, kOracleBall}, kFarAway).look(errors), 0).empty());
}

TEST(OracleEye, APartOfALineEndsWhereThePictureDoes) {
  const OracleScene scene({5, 5, kOracleBall}, kFarAway);
  const auto parts = ofTarget(scene.look(), 2);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(placeOf(oracleLens(), parts[0].p_W).u, 639.5, 1e-6) << "-y is to the right";
  EXPECT_NEAR(placeOf(oracleLens(), parts[0].q_W).u, -0.5, 1e-6);
  EXPECT_NEAR(parts[0].p_W.x, 2, 1e-12);
}

TEST(OracleEye, ARobotCutsALineInTwo) {
  const OracleScene scene({5, 5, kOracleBall}, {1.5, 0, 0.25});
  const auto parts = ofTarget(scene.look(), 2);
  ASSERT_EQ(parts.size(), 2U);
  // The corner of the box at x = 1.4, y = .15 hides what is behind: y = .15 2 / 1.4.
  const double edge = 0.15 * 2 / 1.4, pixel = 4 * 2.06 / oracleLens().fx;
  EXPECT_NEAR(parts[0].q_W.y, -edge, 1.2 * pixel);
  EXPECT_NEAR(parts[1].p_W.y, edge, 1.2 * pixel);
}

TEST(OracleEye, AShrunkCameraSeesTheSameRays) {
  const CameraModel lens = oracleLens(), small = shrunkCamera(lens, 4);
  EXPECT_EQ(small.width, 160);
  const RaySlopes corner = unproject(lens, {-0.5, -0.5}), same = unproject(small, {-0.5, -0.5});
  EXPECT_NEAR(corner.x, same.x, 1e-12);
  EXPECT_NEAR(corner.y, same.y, 1e-12);
}

}  // namespace
}  // namespace murosimf::testing
