// What optics and sensors do to the light of a picture.

#include "murosimf/algorithms/light/light_filters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "book/page.h"
#include "murosimf/algorithms/light/pixel_format.h"
#include "murosimf/algorithms/ray_caster.h"

namespace murosimf::test {
namespace {

constexpr int kWidth = 53, kHeight = 37;  // no multiples of any register

std::size_t at(int u, int v) { return static_cast<std::size_t>(v * kWidth + u); }

LightPicture evenLight(float c) {
  LightPicture light;
  light.resize(kWidth, kHeight);
  for (std::vector<float>& plane : light.plane) std::fill(plane.begin(), plane.end(), c);
  return light;
}

LightPicture colourfulLight() {
  LightPicture light = evenLight(0);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    for (std::size_t i = 0; i < light.pixels(); ++i)
      light.plane[colour][i] = static_cast<float>((i * (7 + colour) + 13 * colour) % 101) / 90.0F;
  }
  return light;
}

bool samePixels(const LightPicture& a, const LightPicture& b) {
  for (std::size_t colour = 0; colour < 3; ++colour) {
    if (std::memcmp(a.plane[colour].data(), b.plane[colour].data(), a.pixels() * sizeof(float)) != 0) return false;
  }
  return true;
}

TEST(LightFilters, GiveTheSameBitsForAnyNumberOfLanes) {
  const std::vector<float> factors = naturalVignetting(makePinholeCamera(kWidth, kHeight, 1.2), 0.8);
  const std::vector<float> weights = gaussianWeights(1.7);
  const auto filtered = [&](LightLanes lanes) {
    LightPicture light = colourfulLight(), work, other = colourfulLight();
    blurLight(light, weights, work, lanes);
    scaleLight(light, {1.1F, 0.9F, 1.3F}, lanes);
    shadeLight(light, factors, lanes);
    addLight(light, other, 0.25F, lanes);
    addLightNoise(light, {0.01F, 0.002F, 12345}, lanes);
    return light;
  };
  const LightPicture scalar = filtered(LightLanes::kOne);
  EXPECT_TRUE(samePixels(scalar, filtered(LightLanes::kEight)));
  if (!isSupported(CastLanes::kSixteen)) GTEST_SKIP() << "no AVX-512 here";
  EXPECT_TRUE(samePixels(scalar, filtered(LightLanes::kSixteen)));
}

TEST(LightFilters, BlurKeepsEvenLightUpToTheBorder) {
  LightPicture light = evenLight(0.6F), work;
  blurLight(light, gaussianWeights(3), work);
  for (std::size_t i = 0; i < light.pixels(); ++i) ASSERT_NEAR(light.plane[1][i], 0.6F, 1e-6F) << i;
}

TEST(LightFilters, BlurSpreadsAPointByItsStandardDeviation) {
  book::Page page({book::Chapter::kPictures,
                   "A picture out of focus spreads a point by the standard deviation that is asked for",
                   R"(\sqrt{\sum c (u - u_0)^2 / \sum c} = \sigma)",
                   "Second moment of a normal distribution",
                   {{"c", "light of a pixel", ""}, {"u", "its column, or its row", "px"}},
                   {"standard deviation $\\sigma$", "px"},
                   {"spread of a point", "px"}});
  for (const double deviation : {0.7, 1.5, 2.0, 3.0}) {
    page.series("along").curve(0.5, 3.2, [](double any) { return any; });
    LightPicture light = evenLight(0), work;
    light.plane[0][at(26, 18)] = 1;
    blurLight(light, gaussianWeights(deviation), work);
    double sum = 0, along = 0, across = 0;
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const double c = static_cast<double>(light.plane[0][at(u, v)]);
        sum += c, along += c * (u - 26) * (u - 26), across += c * (v - 18) * (v - 18);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-5);
    EXPECT_TRUE(page.series("along").near(deviation, std::sqrt(along), deviation, 0.01 * deviation));
    EXPECT_TRUE(page.series("across").near(deviation, std::sqrt(across), deviation, 0.01 * deviation));
  }
}

TEST(LightFilters, NoDefocusChangesNothing) {
  LightPicture light = colourfulLight(), work;
  blurLight(light, gaussianWeights(0), work);
  EXPECT_TRUE(samePixels(light, colourfulLight()));
}

TEST(LightFilters, VarianceOfNoiseGrowsWithTheLight) {
  book::Page page({book::Chapter::kPictures,
                   "The variance of a camera's noise grows with the light",
                   R"(\sigma^2 = \sigma_0^2 + g c)",
                   "Shot noise: electrons are counted, and counts are of Poisson",
                   {{"\\sigma_0", "noise of the dark picture, here 0.01", ""}, {"g", "shot noise, here 0.0004", ""}},
                   {"light $c$", ""},
                   {"variance $\\sigma^2$", ""}});
  for (const float c : {0.0F, 0.25F, 0.5F, 1.0F}) {
    LightPicture light;
    light.resize(400, 300);
    for (std::vector<float>& plane : light.plane) std::fill(plane.begin(), plane.end(), c);
    addLightNoise(light, {0.01F, 0.0004F, 99});
    for (const std::vector<float>& plane : light.plane) {
      double sum = 0, squares = 0;
      for (std::size_t i = 0; i < light.pixels(); ++i) {
        const double d = static_cast<double>(plane[i] - c);
        sum += d, squares += d * d;
      }
      const double n = static_cast<double>(light.pixels()), expected = 1e-4 + 4e-4 * static_cast<double>(c);
      EXPECT_NEAR(sum / n, 0, 4 * std::sqrt(expected / n));
      page.curve(0, 1, [](double any) { return 1e-4 + 4e-4 * any; });
      EXPECT_TRUE(page.near(static_cast<double>(c), squares / n, expected, 0.02 * expected));
    }
  }
}

TEST(LightFilters, ALensDarkensByTheFourthPowerOfTheCosine) {
  const CameraModel camera = makePinholeCamera(101, 101, kPi / 2);
  const std::vector<float> full = naturalVignetting(camera, 1), half = naturalVignetting(camera, 0.5);
  book::Page page({book::Chapter::kPictures,
                   "A lens darkens by the fourth power of the cosine",
                   R"(\frac{E}{E_0} = 1 - a + a \cos^4 \theta)",
                   "Cosine fourth law of natural vignetting, shared out by a",
                   {{"\\theta", "angle to the lens's axis", "deg"}, {"a", "share of the vignetting", ""}},
                   {"angle $\\theta$", "deg"},
                   {"light over light on the axis", ""}});
  const auto falloff = [](double a) {
    return [a](double degrees) { return 1 - a + a * std::pow(std::cos(degrees * kPi / 180), 4); };
  };
  page.series("$a$ = 1").curve(0, 45, falloff(1)), page.series("$a$ = 0.5").curve(0, 45, falloff(0.5));
  for (std::size_t column = 0; column <= 50; column += 5) {
    const std::size_t pixel = 50 * 101 + column;
    const double angle = std::atan((50.0 - static_cast<double>(column)) / camera.fx) * 180 / kPi;
    EXPECT_TRUE(page.series("$a$ = 1").near(angle, static_cast<double>(full[pixel]), falloff(1)(angle), 1e-6));
    EXPECT_TRUE(page.series("$a$ = 0.5").near(angle, static_cast<double>(half[pixel]), falloff(0.5)(angle), 1e-6));
  }
}

TEST(LightFilters, GammaLeavesBlackAndWhiteAndCutsWhatIsBrighter) {
  LightPicture light = evenLight(0.25F);
  light.plane[0][0] = 0, light.plane[0][1] = 1, light.plane[0][2] = 1.7F, light.plane[0][3] = -0.2F;
  applyCurve(light, gammaTable(0.5));
  EXPECT_EQ(light.plane[0][0], 0);
  EXPECT_EQ(light.plane[0][1], 1);
  EXPECT_EQ(light.plane[0][2], 1);
  EXPECT_EQ(light.plane[0][3], 0);
  EXPECT_NEAR(light.plane[0][4], 0.5, 3e-4);
}

TEST(LightFilters, BrightnessIsTheMeanOfLuminance) {
  LightPicture light = evenLight(0.5F);
  EXPECT_NEAR(meanBrightness(light), 0.5, 1e-6);
  scaleLight(light, {4.0F, 1.0F, 1.0F});  // red is cut at 1
  EXPECT_NEAR(meanBrightness(light), 0.299 + 0.5 * (0.587 + 0.114), 1e-6);
}

std::vector<std::uint8_t> bytesOf(float r, float g, float b, PixelFormat format) {
  LightPicture light;
  light.resize(3, 1);
  for (std::size_t i = 0; i < 3; ++i) light.plane[0][i] = r, light.plane[1][i] = g, light.plane[2][i] = b;
  std::vector<std::uint8_t> bytes;
  storePixels(light, format, bytes);
  return bytes;
}

TEST(PixelFormats, HaveTheBytesOfTheirStandards) {
  using Bytes = std::vector<std::uint8_t>;
  EXPECT_EQ(bytesOf(1, 0.5F, 0, PixelFormat::kRgb), (Bytes{255, 128, 0, 255, 128, 0, 255, 128, 0}));
  EXPECT_EQ(bytesOf(1, 0.5F, 0, PixelFormat::kBgr), (Bytes{0, 128, 255, 0, 128, 255, 0, 128, 255}));
  // JFIF: red is (76, 85, 255), blue (29, 255, 107), grey has no colour. A last single column stands for two.
  EXPECT_EQ(bytesOf(1, 0, 0, PixelFormat::kYuyv), (Bytes{76, 85, 76, 255, 76, 85, 76, 255}));
  EXPECT_EQ(bytesOf(0, 0, 1, PixelFormat::kYuyv), (Bytes{29, 255, 29, 107, 29, 255, 29, 107}));
  EXPECT_EQ(bytesOf(0.2F, 0.2F, 0.2F, PixelFormat::kYuyv), (Bytes{51, 128, 51, 128, 51, 128, 51, 128}));
}

TEST(PixelFormats, MakeTheSameOfLightAndOfItsBytes) {
  const LightPicture light = colourfulLight();
  std::vector<std::uint8_t> rgb, direct, by_bytes;
  storePixels(light, PixelFormat::kRgb, rgb);
  for (const PixelFormat format : {PixelFormat::kRgb, PixelFormat::kBgr, PixelFormat::kYuyv}) {
    storePixels(light, format, direct);
    storePixels(rgb, kWidth, kHeight, format, by_bytes);
    EXPECT_EQ(direct, by_bytes) << nameOf(format);
    EXPECT_EQ(direct.size(), bytesPerRow(format, kWidth) * kHeight);
    EXPECT_EQ(pixelFormatOf(nameOf(format)), format);
  }
  EXPECT_EQ(pixelFormatOf("yuv"), std::nullopt);
}

}  // namespace
}  // namespace murosimf::test
