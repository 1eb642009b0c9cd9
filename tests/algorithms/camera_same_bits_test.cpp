#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <thread>

#include "algorithms/camera_scene.h"
#include "algorithms/picture_hash.h"
#include "murosimf/algorithms/scene_preparation.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;
using picture_hash::hashOf;

bool equal(const Picture& a, const Picture& b) {
  return a.rgb == b.rgb && a.label == b.label && a.depth.size() == b.depth.size() &&
         std::memcmp(a.depth.data(), b.depth.data(), a.depth.size() * sizeof(float)) == 0;
}

struct Shot {
  CameraModel camera = camera_scene::headCamera(320, 240);
  Pose X_WC = cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35);
  CastOptions options;
  bool shadows = false;
};

std::vector<Shot> shots() {
  std::vector<Shot> all(6);
  all[1].X_WC = cameraPose({1.9, 0.9, 0.45}, -2.4, 0.5);
  all[1].options.sensor = {1.1F, 0.02F, noiseKey(3, "robots.red.1.head", 17)};
  all[2].X_WC = lookAt({-3.5, -2.5, 2.5}, {0, 0, 0}), all[2].options.antialias = true, all[2].shadows = true;
  all[3].camera = camera_scene::headCamera(161, 99);  // no multiple of a tile
  all[3].X_WC = cameraPose({0.8, 0.2, 0.4}, 0.8, 0.9);
  all[4].X_WC = cameraPose({0.83, 0.33, 0.42}, 3.0, 0.9);                      // amid a robot's parts
  all[5].X_WC = {fromRollPitchYaw(Vector3{2.0, 0.4, 1.0}), {0.2, 0.1, 0.05}};  // fallen
  return all;
}

Picture cast(const Shot& shot, CastLanes lanes) {
  const RayTable rays(shot.camera);
  RayScene scene = camera_scene::makeGame();
  scene.ground_shadows = shot.shadows;
  CastOptions options = shot.options;
  options.lanes = lanes;
  PreparedScene work;
  Picture picture;
  castPicture(rays, scene, shot.X_WC, {}, options, work, picture);
  return picture;
}

TEST(CameraSameBits, LanesAreEqualToOneRayAfterTheOther) {
  for (const Shot& shot : shots()) {
    const Picture one = cast(shot, CastLanes::kOne);
    EXPECT_TRUE(equal(one, cast(shot, CastLanes::kEight)));
    EXPECT_TRUE(equal(one, cast(shot, CastLanes::kWidest)));
    EXPECT_TRUE(!isSupported(CastLanes::kSixteen) || equal(one, cast(shot, CastLanes::kSixteen)));
  }
}

TEST(CameraSameBits, PicturesAreThoseOfEveryOtherCompilerAndMachine) {
  const std::uint64_t expected[] = {13145570542779561741U, 17563033013260747825U, 2171546952232763679U,
                                    12700930159810318293U, 8016902987593780068U,  18020377488551135532U};
  const std::vector<Shot> all = shots();
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(hashOf(cast(all[k], CastLanes::kWidest)), expected[k]) << k;
}

TEST(CameraSameBits, BandsOfSeveralThreadsMakeTheSamePicture) {
  for (const Shot& shot : shots()) {
    const Picture whole = cast(shot, CastLanes::kEight);
    const RayTable rays(shot.camera);
    RayScene scene = camera_scene::makeGame();
    scene.ground_shadows = shot.shadows;
    PreparedScene work;
    prepareScene(rays, scene, shot.X_WC, {}, shot.options.shadows, work);
    Picture picture;
    picture.resize(shot.camera.width, shot.camera.height);
    const int cut[] = {0, 5, 48, 63, shot.camera.height};
    std::vector<std::thread> threads;
    for (int k = 3; k >= 0; --k)
      threads.emplace_back([&, k] { castRows(rays, work, shot.options, cut[k], cut[k + 1], picture); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(equal(whole, picture));
  }
}

TEST(CameraSameBits, RowsOutsideABandAreNotTouched) {
  const RayTable rays(camera_scene::headCamera(160, 120));
  const RayScene scene = camera_scene::makeGame();
  PreparedScene work;
  prepareScene(rays, scene, cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35), {}, false, work);
  Picture picture;
  picture.resize(160, 120);
  std::fill(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{77});
  std::fill(picture.depth.begin(), picture.depth.end(), -5.0F);
  castRows(rays, work, {}, 35, 70, picture);
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) EXPECT_EQ(picture.depth[picture.index(u, v)] == -5.0F, v < 35 || v >= 70);
  for (std::size_t i = 0; i < 160 * 35 * 3; ++i) EXPECT_EQ(picture.rgb[i], 77);
  for (std::size_t i = 160 * 70 * 3; i < picture.rgb.size(); ++i) EXPECT_EQ(picture.rgb[i], 77);
}

TEST(CameraSameBits, CullingLeavesOutOnlyWhatIsNotSeen) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  for (const Shot& shot : shots()) {
    const Picture culled = cast(shot, CastLanes::kEight);
    const RayTable rays(shot.camera);
    RayScene scene = camera_scene::makeGame();
    scene.ground_shadows = shot.shadows;
    PreparedScene work;
    prepareScene(rays, scene, shot.X_WC, {}, shot.options.shadows, work);
    for (PreparedScene::Extent& e : work.extents) e.x_low = e.y_low = -kHuge, e.x_high = e.y_high = kHuge;
    sortIntoRows(rays, work);
    Picture all;
    all.resize(shot.camera.width, shot.camera.height);
    castRows(rays, work, shot.options, 0, all.height, all);
    EXPECT_TRUE(equal(culled, all));
  }
}

TEST(CameraSameBits, PictureDoesNotDependOnWhereItsTilesLie) {
  // A pinhole camera cut out of a larger one: the same rays in other tiles.
  CameraModel large = makePinholeCamera(320, 240, 1.2), part = large;
  const int left = 37, top = 22;
  part.width = 200, part.height = 150, part.cx -= left, part.cy -= top;
  const RayScene scene = camera_scene::makeGame();
  PreparedScene work;
  Picture a, b;
  for (const double heading : {0.2, 1.7, 3.0, -1.3}) {
    const Pose X_WC = cameraPose({-0.9, 0.4, 0.5}, heading, 0.3);
    castPicture(RayTable(large), scene, X_WC, {}, {}, work, a);
    castPicture(RayTable(part), scene, X_WC, {}, {}, work, b);
    for (int v = 0; v < part.height; ++v)
      for (int u = 0; u < part.width; ++u) {
        const std::size_t i = a.index(u + left, v + top), j = b.index(u, v);
        ASSERT_EQ(a.label[i], b.label[j]);
        ASSERT_EQ(a.depth[i], b.depth[j]);
        ASSERT_EQ(std::memcmp(&a.rgb[3 * i], &b.rgb[3 * j], 3), 0) << u << " " << v;
      }
  }
}

TEST(CameraSameBits, WorkMemoryCarriesNothingOverAndGrowsNoMore) {
  const RayTable rays(camera_scene::headCamera(320, 240));
  RayScene scene = camera_scene::makeGame();
  PreparedScene work, fresh;
  Picture picture, expected;
  const Pose first = cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35), second = cameraPose({-2.2, -1, 0.6}, 0.9, 0.3);
  castPicture(rays, scene, second, {}, {}, fresh, expected);
  castPicture(rays, scene, second, {}, {}, work, picture);
  castPicture(rays, scene, first, {}, {}, work, picture);
  const auto* surfaces = work.surfaces.data();
  const auto* rows = work.row_surface.data();
  const auto* bytes = picture.rgb.data();
  castPicture(rays, scene, second, {}, {}, work, picture);
  EXPECT_TRUE(equal(picture, expected));
  EXPECT_EQ(surfaces, work.surfaces.data());
  EXPECT_EQ(rows, work.row_surface.data());
  EXPECT_EQ(bytes, picture.rgb.data());
}

}  // namespace
}  // namespace murosimf
