// Pictures that are gathered over time: against closed forms of what moves past a camera.

#include "murosimf/algorithms/light/shutter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/camera_scene.h"
#include "book/page.h"
#include "murosimf/algorithms/light/pixel_format.h"

namespace murosimf::test {
namespace {

constexpr double kDistance = 2.0, kSpeed = 1.5;  // of a post before the camera [m], [m/s]
constexpr int kPostLabel = 7;

/// A tall white post before a camera that looks along x, high above a black ground.
struct PostAhead {
  RayTable rays{makePinholeCamera(320, 240, 1.0)};
  RayScene scene;
  MovingCamera camera{camera_scene::cameraPose({0, 0, 5}, 0, 0), {}};
  std::vector<std::uint32_t> hidden;
  ShutterWork work;
  Picture picture;
  LightPicture light;

  PostAhead() {
    scene.ground.half_length = scene.ground.half_width = 100;
    scene.ground.carpet = scene.ground.surroundings = {0, 0, 0};
    scene.sky = {0, 0, 0};
    scene.ambient = 1;
    scene.drawables.push_back(
        camera_scene::place(makeBox({0.001, 0.1, 20}), {{}, {kDistance, 0, 0}}, {1, 1, 1}, kPostLabel));
    scene.motions = {{}};
  }
  void cast(const Shutter& shutter) {
    castThroughShutter(rays, scene, camera, hidden, {}, shutter, work, picture, light);
  }
  double focalLength() const { return rays.camera().fx; }
  /// Mean column of the post in a row; weights are its light.
  double middle(int v) const {
    double sum = 0, moment = 0;
    for (int u = 0; u < picture.width; ++u) {
      const double c = static_cast<double>(light.plane[1][picture.index(u, v)]);
      sum += c, moment += c * u;
    }
    return moment / sum;
  }
  /// Columns that are lit by more than a share of full light.
  int width(int v, float share) const {
    int count = 0;
    for (int u = 0; u < picture.width; ++u) count += light.plane[1][picture.index(u, v)] > share ? 1 : 0;
    return count;
  }
};

TEST(Shutter, OfAMomentShowsWhatACameraWithoutOneShows) {
  const RayScene scene = camera_scene::makeGame();
  const RayTable rays(camera_scene::headCamera(200, 150));
  const Pose X_WC = camera_scene::cameraPose({-1.5, 0.2, 0.5}, 0.1, 0.4);
  PreparedScene prepared;
  Picture plain, gathered;
  castPicture(rays, scene, X_WC, {}, {}, prepared, plain);
  ShutterWork work;
  LightPicture light;
  castThroughShutter(rays, scene, {X_WC, {}}, {}, {}, {}, work, gathered, light);
  std::vector<std::uint8_t> bytes;
  storePixels(light, PixelFormat::kRgb, bytes);
  EXPECT_EQ(bytes, plain.rgb);
  EXPECT_EQ(gathered.label, plain.label);
}

TEST(Shutter, RollingLeansAPostThatPassesByItsSpeed) {
  PostAhead ahead;
  ahead.scene.motions[0].v = {0, -kSpeed, 0};  // to the right
  const double readout = 0.03;
  ahead.cast({readout, 0, 1});
  // Row v is seen readout (1 - v / (H - 1)) before the snapshot, when the post was further to the left.
  book::Page page({book::Chapter::kPictures,
                   "A rolling shutter leans a post that passes by its speed",
                   R"(u = u_0 - \frac{f v}{z} T \left( 1 - \frac{j}{H - 1} \right))",
                   "Row j is read T (1 - j/(H - 1)) before the snapshot",
                   {{"T", "readout time, here 30 ms", "s"},
                    {"f", "focal length", "px"},
                    {"v", "speed", "m/s"},
                    {"z", "distance", "m"}},
                   {"row $j$", "px"},
                   {"column of the post's middle $u$", "px"}});
  const auto column = [&](double v) {
    return 159.5 - ahead.focalLength() * kSpeed * readout * (1 - v / 239.0) / kDistance;
  };
  page.curve(0, 239, column);
  for (const int v : {8, 40, 72, 119, 168, 200, 232})
    EXPECT_TRUE(page.near(v, ahead.middle(v), column(v), 0.8));  // bands of 16 rows, whole pixels
}

TEST(Shutter, RollingLeansTheWorldWhenTheCameraTurns) {
  PostAhead ahead;
  const double rate = 1.0, readout = 0.03;
  ahead.camera.V_WC.w = {0, 0, rate};  // to the left: what stands still goes to the right
  ahead.cast({readout, 0, 1});
  const double first = 159.5 + ahead.focalLength() * std::tan(-rate * readout);
  EXPECT_NEAR(ahead.middle(0), first, 0.8);
  EXPECT_NEAR(ahead.middle(239), 159.5, 0.8);
}

TEST(Shutter, BlurSpreadsAnEdgeByTheWayOfItsExposure) {
  book::Page page({book::Chapter::kPictures,
                   "Motion spreads an edge by the way of its exposure",
                   R"(w = w_0 \pm \frac{f v t_e}{z})",
                   "Light is summed up while the post moves",
                   {{"w_0", "width of the post at rest", "px"},
                    {"f", "focal length", "px"},
                    {"v", "speed", "m/s"},
                    {"z", "distance", "m"}},
                   {"exposure $t_e$", "s"},
                   {"width of the post $w$", "px"}});
  for (const double exposure : {0.005, 0.01, 0.02}) {
    PostAhead ahead;
    ahead.scene.motions[0].v = {0, -kSpeed, 0};
    const double rate = ahead.focalLength() * kSpeed / kDistance, way = rate * exposure;  // [px/s], [px]
    ahead.cast({0, exposure, 32});
    const double post = ahead.focalLength() * 0.1 / kDistance;
    page.series("lit at all").curve(0, 0.02, [&](double t) { return post + rate * t; });
    EXPECT_TRUE(page.near(exposure, ahead.width(120, 0.001F), post + way, 2));
    page.series("fully lit").curve(0, 0.02, [&](double t) { return post - rate * t; });
    EXPECT_TRUE(page.near(exposure, ahead.width(120, 0.999F), post - way, 2));
    EXPECT_NEAR(ahead.middle(120), 159.5 - 0.5 * way, 0.5) << "the middle of the exposure";
  }
}

TEST(Shutter, BlurLeavesWhatStandsStillSharp) {
  PostAhead still;
  still.cast({});
  const LightPicture sharp = still.light;
  still.cast({0.02, 0.02, 8});
  for (std::size_t i = 0; i < sharp.pixels(); ++i) ASSERT_NEAR(still.light.plane[0][i], sharp.plane[0][i], 1e-6F);
}

}  // namespace
}  // namespace murosimf::test
