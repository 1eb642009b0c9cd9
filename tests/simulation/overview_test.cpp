#include "murosimf/simulation/overview.h"

#include "simulation/bouncing_balls.h"

namespace murosimf {
namespace {

TEST(Overview, SeesTheWholeCarpetOfAnyFieldAboveTheCaption) {
  for (const auto& [half_length, half_width] : {std::pair{2.75, 2.0}, {5.5, 4.0}, {1.0, 3.0}, {8.0, 2.0}}) {
    for (const auto& [width, height] : {std::pair{1280, 720}, {960, 540}, {480, 480}}) {
      PaintedGround ground;
      ground.half_length = half_length, ground.half_width = half_width;
      const CameraModel camera = makePinholeCamera(width, height, 0.7);
      const Pose X_WC = overviewPose(camera, ground);
      double left = width, right = 0, top = height, bottom = 0;
      for (const double x : {-half_length, half_length}) {
        for (const double y : {-half_width, half_width}) {
          const auto place = projectPoint(camera, applyInverse(X_WC, Vector3{x, y, 0}));
          ASSERT_TRUE(place);
          left = std::min(left, place->u), right = std::max(right, place->u);
          top = std::min(top, place->v), bottom = std::max(bottom, place->v);
        }
      }
      EXPECT_GE(left, 0);
      EXPECT_LT(right, width);
      EXPECT_GE(top, 0);
      EXPECT_LT(bottom, height - Canvas::captionHeight());
      // and it is as near as it can be: the field fills the picture one way or the other
      EXPECT_GT(std::max((right - left) / width, (bottom - top) / height), 0.8) << half_length << " " << width;
    }
  }
}

TEST(Overview, ShowsTheBallWhereItsProjectionFalls) {
  test::BouncingBalls game;
  game.run(200);
  OverviewSource source(*game.simulation);
  OverviewShot shot = source.emptyShot();
  source.take(shot);
  Overview overview(640, 360, shot.scene.ground);
  const Picture& picture = overview.render(shot);
  for (const ObjectId ball : {game.orange, game.blue}) {
    const auto place = projectPoint(overview.camera(), applyInverse(overview.cameraPose(), game.place(ball)));
    ASSERT_TRUE(place);
    const std::uint8_t* p = &picture.rgb[3 * picture.index(int(std::lround(place->u)), int(std::lround(place->v)))];
    const int more = ball == game.orange ? p[0] : p[2], less = ball == game.orange ? p[2] : p[0];
    EXPECT_GT(more, 2 * less);
  }
  const auto right = projectPoint(overview.camera(), applyInverse(overview.cameraPose(), Vector3{1, 0, 0}));
  const auto far = projectPoint(overview.camera(), applyInverse(overview.cameraPose(), Vector3{0, 1, 0}));
  EXPECT_GT(right->u, 320 + 50);
  EXPECT_LT(far->v, right->v - 30);
}

TEST(Overview, IsWrittenInItsSize) {
  const test::Folder folder;
  test::BouncingBalls game;
  game.run(1);
  writeOverview(folder / "overview.png", *game.simulation, gameCaption(game.simulation->time(), 2, 1));
  const std::string bytes = test::readBytes(folder / "overview.png");
  ASSERT_GT(bytes.size(), 1000U);
  const auto number = [&](std::size_t i) {
    return static_cast<unsigned char>(bytes[i]) * 256 + static_cast<unsigned char>(bytes[i + 1]);
  };
  EXPECT_EQ(number(18), 1280);  // PNG: width in bytes 16 to 19, height in 20 to 23, big endian
  EXPECT_EQ(number(22), 720);
}

TEST(Overview, CaptionTellsTimeAndScore) { EXPECT_EQ(gameCaption(12.345, 2, 0), "T 12.35   RED 2 : 0 BLUE"); }

}  // namespace
}  // namespace murosimf
