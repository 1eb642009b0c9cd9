#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "algorithms/camera_scene.h"
#include "book/page.h"

namespace murosimf {
namespace {

/// A grey wall: all bytes are 127.5 plus noise.
struct Wall {
  explicit Wall(int width = 640, int height = 480) : rays(makePinholeCamera(width, height, 0.5)) {
    scene.sky = {0.5F, 0.5F, 0.5F};
  }
  const Picture& shoot(float deviation, std::uint64_t key, float gain = 1.0F) {
    CastOptions options;
    options.sensor = {gain, deviation, key};
    castPicture(rays, scene, camera_scene::cameraPose({0, 0, 1}, 0, -0.8), {}, options, work, picture);
    return picture;
  }

  RayTable rays;
  RayScene scene;
  PreparedScene work;
  Picture picture;
};

struct Moments {
  double mean = 0, variance = 0, skewness = 0, kurtosis = 0;
};
Moments momentsOf(const std::vector<std::uint8_t>& bytes) {
  Moments m;
  const double n = double(bytes.size());
  for (const double b : bytes) m.mean += b / n;
  for (const double b : bytes) m.variance += (b - m.mean) * (b - m.mean) / n;
  for (const double b : bytes) {
    const double z = (b - m.mean) / std::sqrt(m.variance);
    m.skewness += z * z * z / n, m.kurtosis += z * z * z * z / n;
  }
  return m;
}

TEST(CameraNoise, HasTheMeanVarianceAndShapeOfANormalDistribution) {
  Wall wall;
  const double deviation = 0.08, in_bytes = 255 * deviation;
  const Moments m = momentsOf(wall.shoot(float(deviation), noiseKey(1, "head", 0)).rgb);
  EXPECT_NEAR(m.mean, 127.5, 0.1);                                             // 921 600 numbers: 5 standard errors
  EXPECT_NEAR(m.variance, in_bytes * in_bytes + 1.0 / 12, 0.01 * m.variance);  // rounding adds a twelfth
  EXPECT_NEAR(m.skewness, 0.0, 0.015);
  EXPECT_NEAR(m.kurtosis, 3.0, 0.03);
}

TEST(CameraNoise, FillsTheNormalDistributionsQuantiles) {
  Wall wall;
  const Picture& p = wall.shoot(0.1F, noiseKey(2, "head", 5));
  const double in_bytes = 25.5;
  const auto normal = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  book::Page page({book::Chapter::kPictures,
                   "Noise of pictures fills the quantiles of the normal distribution",
                   R"(P(x < z \sigma) = \frac{1}{2} \mathrm{erfc}\left( -\frac{z}{\sqrt{2}} \right))",
                   "Normal distribution, of 921 600 bytes",
                   {{"\\sigma", "standard deviation, here 25.5 bytes", ""}},
                   {"quantile $z$", ""},
                   {"share of bytes below", ""}});
  page.curve(-3, 3, normal);
  for (const double z : {-2.5, -1.5, -0.5, 0.5, 1.5, 2.5}) {
    const double cut = std::floor(127.5 + z * in_bytes) + 0.5;
    double below = 0;
    for (const std::uint8_t byte : p.rgb) below += byte < cut;
    const double at = (cut - 127.5) / in_bytes;
    EXPECT_TRUE(page.near(at, below / double(p.rgb.size()), normal(at), 0.003)) << z;
  }
}

TEST(CameraNoise, NeighboursChannelsAndFramesAreIndependent) {
  Wall wall;
  const std::vector<std::uint8_t> a = wall.shoot(0.1F, noiseKey(1, "head", 0)).rgb;
  const std::vector<std::uint8_t> b = wall.shoot(0.1F, noiseKey(1, "head", 1)).rgb;
  const std::vector<std::uint8_t> c = wall.shoot(0.1F, noiseKey(1, "chest", 0)).rgb;
  const std::vector<std::uint8_t> d = wall.shoot(0.1F, noiseKey(2, "head", 0)).rgb;
  const auto correlation = [](const auto& x, const auto& y, std::size_t shift) {
    double sum = 0;
    for (std::size_t i = 0; i + shift < x.size(); ++i) sum += (x[i] - 127.5) * (y[i + shift] - 127.5);
    return sum / double(x.size()) / (25.5 * 25.5);
  };
  for (const std::size_t shift : {1U, 2U, 3U, 6U, 48U, 1920U}) EXPECT_NEAR(correlation(a, a, shift), 0, 0.006) << shift;
  for (const auto* other : {&b, &c, &d}) EXPECT_NEAR(correlation(a, *other, 0), 0, 0.006);
}

TEST(CameraNoise, SameKeyGivesTheSamePicture) {
  Wall wall(100, 60), again(100, 60);
  EXPECT_EQ(wall.shoot(0.05F, noiseKey(1, "head", 3)).rgb, again.shoot(0.05F, noiseKey(1, "head", 3)).rgb);
  EXPECT_NE(wall.shoot(0.05F, noiseKey(1, "head", 3)).rgb, again.shoot(0.05F, noiseKey(1, "head", 4)).rgb);
}

TEST(CameraNoise, IsTheSameInBandsInAnyOrder) {
  Wall wall(160, 120);
  const Picture whole = wall.shoot(0.05F, 99);
  CastOptions options;
  options.sensor = {1.0F, 0.05F, 99};
  Picture bands;
  bands.resize(160, 120);
  for (int row = 119; row >= 0; --row) castRows(wall.rays, wall.work, options, row, row + 1, bands);
  EXPECT_EQ(whole.rgb, bands.rgb);
}

TEST(CameraNoise, BytesAreCutAtBlackAndWhite) {
  Wall wall(64, 48);
  for (const std::uint8_t byte : wall.shoot(0.02F, 5, 10.0F).rgb) EXPECT_EQ(byte, 255);
  for (const std::uint8_t byte : wall.shoot(0.0F, 5, 0.0F).rgb) EXPECT_EQ(byte, 0);
  const Moments dark = momentsOf(wall.shoot(0.1F, 5, 0.0F).rgb);
  EXPECT_NEAR(dark.mean, 25.5 / std::sqrt(2 * kPi), 0.5);  // half of the distribution is cut to 0
}

TEST(CameraNoise, LeavesDepthAndLabel) {
  Wall wall(160, 120);
  const Picture quiet = wall.shoot(0.0F, 1), noisy = wall.shoot(0.2F, 1);
  EXPECT_EQ(quiet.depth, noisy.depth);
  EXPECT_EQ(quiet.label, noisy.label);
}

}  // namespace
}  // namespace murosimf
