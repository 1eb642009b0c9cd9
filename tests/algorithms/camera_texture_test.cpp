/// @file A picture laid on the carpet: its place, its sizes, and what is left of it far away.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "algorithms/camera_scene.h"

namespace murosimf {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Field {
  explicit Field(const CameraModel& model = makePinholeCamera(640, 480, 1.0)) : camera(model), rays(camera) {
    scene.ambient = 1.0F;
    scene.ground.surroundings = scene.sky = {0, 0, 0};
    scene.ground.half_length = 3, scene.ground.half_width = 2;
  }
  void lay(int width, int height, const Bytes& rgb) {
    scene.ground.texture = std::make_shared<const GroundTexture>(width, height, rgb);
  }
  Picture shoot(const Pose& X_WC, CastLanes lanes = CastLanes::kWidest) {
    CastOptions options;
    options.lanes = lanes;
    PreparedScene work;
    Picture picture;
    castPicture(rays, scene, X_WC, {}, options, work, picture);
    return picture;
  }
  CameraModel camera;
  RayTable rays;
  RayScene scene;
};

Bytes noise(int pixels) {
  std::mt19937 random(4);
  Bytes bytes(3 * static_cast<std::size_t>(pixels));
  for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random());
  return bytes;
}

TEST(GroundTexture, KeepsThePicturesMeanAtEverySize) {
  for (const auto& [width, height, side] : {std::tuple{64, 64, 64}, {100, 37, 128}, {1, 1, 1}, {3, 200, 256}}) {
    const Bytes bytes = noise(width * height);
    const GroundTexture texture(width, height, bytes);
    EXPECT_EQ(texture.side(0), side);
    EXPECT_EQ(texture.side(texture.levels() - 1), 1);
    double mean = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 3) mean += bytes[i];
    mean /= width * height;
    for (int level = 0; level < texture.levels(); ++level) {
      double sum = 0;
      for (int row = 0; row < texture.side(level); ++row)
        for (int column = 0; column < texture.side(level); ++column) sum += texture.texel(level, column, row) & 255U;
      EXPECT_NEAR(sum / texture.side(level) / texture.side(level), mean, 0.6) << level;
    }
  }
  EXPECT_THROW(GroundTexture(2, 2, Bytes(11)), std::invalid_argument);
}

TEST(CameraTexture, ItsUpperEdgeLiesTowardsPlusYAndItsLeftTowardsMinusX) {
  Field f;
  f.lay(2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
  const Picture p = f.shoot(lookAt({0, 0, 6}, {0, 0, 0}));  // row 0 towards +x, so +y lies left
  const auto at = [&](double x, double y) {
    const int u = int(std::lround(f.camera.cx - y / 6 * f.camera.fx)),
              v = int(std::lround(f.camera.cy - x / 6 * f.camera.fx));
    const std::uint8_t* c = &p.rgb[3 * p.index(u, v)];
    return std::array<int, 3>{c[0], c[1], c[2]};
  };
  EXPECT_EQ(at(-1.5, 1.0), (std::array<int, 3>{255, 0, 0}));
  EXPECT_EQ(at(1.5, 1.0), (std::array<int, 3>{0, 255, 0}));
  EXPECT_EQ(at(-1.5, -1.0), (std::array<int, 3>{0, 0, 255}));
  EXPECT_EQ(at(1.5, -1.0), (std::array<int, 3>{255, 255, 255}));
}

TEST(CameraTexture, OfOneColourIsACarpetOfThatColour) {
  Field plain, laid;
  plain.scene.ground.carpet = {100 / 255.0F, 200 / 255.0F, 50 / 255.0F};
  laid.lay(5, 7, [] {
    Bytes b;
    for (int i = 0; i < 35; ++i) b.insert(b.end(), {100, 200, 50});
    return b;
  }());
  for (Field* f : {&plain, &laid}) f->scene.ground.lines = {{-2, 0, 2, 0.3, 0.05}};
  for (const double size : {0.0, 0.7}) {
    laid.scene.ground.texture_size = size;
    const Pose X_WC = camera_scene::cameraPose({-1.5, -0.3, 0.5}, 0.2, 0.3);
    const Picture a = plain.shoot(X_WC), b = laid.shoot(X_WC);
    for (std::size_t i = 0; i < a.rgb.size(); ++i) ASSERT_NEAR(a.rgb[i], b.rgb[i], 1) << i;
  }
}

TEST(CameraTexture, FadesToItsMeanFarAwayAndDoesNotFlicker) {
  Field f;
  Bytes stripes;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column) stripes.insert(stripes.end(), 3, column % 2 == 0 ? 0 : 200);
  f.lay(64, 64, stripes);
  f.scene.ground.half_length = f.scene.ground.half_width = 60, f.scene.ground.texture_size = 1.0;
  const Picture p = f.shoot(camera_scene::cameraPose({-28, 0, 0.5}, 0.3, 0.05));
  int far = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const std::size_t i = p.index(u, v);
      if (p.label[i] != kGroundLabel || p.depth[i] < 12 || p.depth[i] > 50) continue;
      ++far;
      EXPECT_NEAR(p.rgb[3 * i], 100, 25) << u << " " << v << " " << p.depth[i];
    }
  EXPECT_GT(far, 1000);
  const Picture near = f.shoot(lookAt({0, 0, 0.2}, {0, 0, 0}));
  const auto count = [&](int low, int high) {
    return std::count_if(near.rgb.begin(), near.rgb.end(), [&](int byte) { return byte >= low && byte <= high; });
  };
  EXPECT_GT(count(0, 30), 100000) << "stripes are seen near by";
  EXPECT_GT(count(170, 200), 100000);
}

TEST(CameraTexture, PicturesAreTheSameForAnyNumberOfLanes) {
  Field f(camera_scene::headCamera(323, 241));
  f.lay(200, 90, noise(200 * 90));
  for (const double size : {0.0, 1.0, 0.013}) {
    f.scene.ground.texture_size = size;
    const Pose X_WC = camera_scene::cameraPose({-1.5, -0.3, 0.5}, 0.2, 0.2);
    const Picture one = f.shoot(X_WC, CastLanes::kOne);
    EXPECT_EQ(one.rgb, f.shoot(X_WC, CastLanes::kEight).rgb);
    EXPECT_EQ(one.rgb, f.shoot(X_WC, CastLanes::kWidest).rgb);
  }
}

}  // namespace
}  // namespace murosimf
