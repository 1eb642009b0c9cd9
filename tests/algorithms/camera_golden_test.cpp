/// @file Golden pictures of the ray caster, byte for byte: a number for each thing that a picture can be made of.
///
/// Each picture was looked at before its number was written down. One that differs is written into the folder for
/// temporary files, and the message says where.

#include <gtest/gtest.h>

#include "algorithms/camera_scene.h"
#include "algorithms/mesh_shapes.h"
#include "algorithms/picture_hash.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;

struct Shot {
  std::string name;
  CameraModel camera = camera_scene::headCamera(320, 240);
  RayScene scene = camera_scene::makeGame();
  CastOptions options{};
  Pose X_WC = cameraPose({-0.9, 0.35, 0.55}, -0.3, 0.4);
  std::uint64_t expected = 0;
};

Picture cast(const Shot& shot, CastLanes lanes) {
  CastOptions options = shot.options;
  options.lanes = lanes;
  PreparedScene work;
  Picture picture;
  castPicture(RayTable(shot.camera), shot.scene, shot.X_WC, {}, options, work, picture);
  return picture;
}

void expectGolden(const Shot& shot) {
  for (const CastLanes lanes : {CastLanes::kOne, CastLanes::kEight, CastLanes::kSixteen}) {
    if (!isSupported(lanes)) continue;
    const Picture picture = cast(shot, lanes);
    const std::uint64_t hash = picture_hash::hashOf(picture);
    if (hash == shot.expected) continue;
    const std::string file = testing::TempDir() + "murosimf_" + shot.name + ".ppm";
    picture_hash::writePpm(file, picture);
    ADD_FAILURE() << shot.name << ", lanes " << int(lanes) << ": " << hash << "U; the picture: " << file;
  }
}

/// A lawn in bands with a bright circle and a red corner, so that one sees which way it lies.
std::shared_ptr<const GroundTexture> lawn() {
  constexpr int kWidth = 150, kHeight = 100;
  std::vector<std::uint8_t> rgb;
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column) {
      const int x = column - kWidth / 2, y = row - kHeight / 2, r = x * x + y * y;
      const int green = (column / 15 % 2 == 0 ? 150 : 110) + (r > 900 && r < 1300 ? 90 : 0);
      const bool corner = row < 12 && column < 12;
      for (const int c : {corner ? 220 : 40, corner ? 40 : green, 50}) rgb.push_back(static_cast<std::uint8_t>(c));
    }
  return std::make_shared<const GroundTexture>(kWidth, kHeight, rgb);
}

/// Robots, goals and ball as triangles: closed meshes, and an open one, a roof.
RayScene gameOfMeshes() {
  RayScene scene = camera_scene::makeGame();
  mesh_shapes::drawAsMeshes(16, scene);
  mesh_shapes::Triangles roof;
  mesh_shapes::addGrid(
      2, 1,
      [](int i, int j) {
        return Vector3{0.3 * (i - 1), 0.5 * (j - 0.5), i == 1 ? 0.2 : 0.0};
      },
      roof);
  Drawable& d = scene.drawables.emplace_back(
      camera_scene::place({}, {rotationZ(0.7), {0.2, 0.35, 0.12}}, {0.8F, 0.7F, 0.3F}, 30));
  d.mesh = roof.mesh();
  return scene;
}

TEST(CameraGolden, TriangleMeshes) {
  Shot shot{.name = "meshes", .scene = gameOfMeshes(), .expected = 9039894803978242058U};
  expectGolden(shot);
  shot.name = "meshes_close", shot.X_WC = cameraPose({0.55, 0.05, 0.45}, 0.6, 0.4),
  shot.expected = 5171297860193944809U;
  expectGolden(shot);
}

TEST(CameraGolden, HardShadowsOfPrimitivesAndMeshes) {
  Shot shot{.name = "shadows", .expected = 13624419635113270339U};
  shot.options.shadows = true;
  expectGolden(shot);
  shot.name = "shadows_of_meshes", shot.scene = gameOfMeshes(), shot.expected = 3665914163269397471U;
  expectGolden(shot);
}

TEST(CameraGolden, AntialiasedOutlinesAndShadowEdges) {
  Shot shot{.name = "antialiased", .expected = 3753807046790010060U};
  shot.options.antialias = true;
  expectGolden(shot);
  shot.name = "antialiased_shadows", shot.options.shadows = true, shot.scene = gameOfMeshes();
  shot.expected = 10776878007914736031U;
  expectGolden(shot);
}

TEST(CameraGolden, PictureOnTheCarpet) {
  Shot shot{.name = "carpet", .X_WC = lookAt({-3.5, -2.5, 2.5}, {0, 0, 0}), .expected = 8525140798905779844U};
  shot.scene.ground.texture = lawn();
  expectGolden(shot);  // once, over all of it
  shot.name = "carpet_tiles", shot.scene.ground.texture_size = 0.8, shot.X_WC = Shot().X_WC;
  shot.expected = 13420198312339632861U;
  expectGolden(shot);
}

TEST(CameraGolden, LensOfEachKind) {
  CameraModel rational{320, 240, 225, 226, 161, 118, 0.01, LensKind::kRational, {}};
  rational.kc = {-0.3, 0.1, 5e-4, 1e-3, -0.01, 0.02, 0.003, 0.001, 2e-3, -1e-3, -3e-3, 5e-4};
  CameraModel fisheye{320, 240, 144, 144, 158, 121.5, 0, LensKind::kFisheye, {-0.015, 0.008, -0.006, 0.001}};
  CameraModel continued{320, 240, 160, 160, 159.5, 119.5, 0, LensKind::kRational, {-0.25, 0.07, 1e-3, 2e-3, -0.008}};
  continueLinearly(continued);
  expectGolden({.name = "pinhole", .camera = makePinholeCamera(320, 240, 1.2), .expected = 3848109808824165690U});
  expectGolden({.name = "plumb_bob", .expected = 6119296655572841835U});
  expectGolden({.name = "rational", .camera = rational, .expected = 15813796766125382257U});
  expectGolden({.name = "fisheye", .camera = fisheye, .expected = 17643617205141332729U});
  expectGolden({.name = "continued", .camera = continued, .expected = 7182880231704123633U});
}

TEST(CameraGolden, NumbersTellPicturesApart) {
  Shot shot;
  Picture picture = cast(shot, CastLanes::kWidest);
  const std::uint64_t hash = picture_hash::hashOf(picture);
  ++picture.rgb[1000];
  EXPECT_NE(picture_hash::hashOf(picture), hash);
  --picture.rgb[1000], ++picture.label[2000];
  EXPECT_NE(picture_hash::hashOf(picture), hash);
}

}  // namespace
}  // namespace murosimf
