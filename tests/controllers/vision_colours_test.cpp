/// Colours are told by proportions: the same class under every light, in shade, and with noise.

#include <gtest/gtest.h>

#include <array>

#include "murosimf/math/random.h"
#include "player/vision/colours.h"

namespace murosimf::controllers {
namespace {

struct Paint {
  const char* name;
  std::array<double, 3> rgb;
  Colour colour;
  bool upright;  ///< stands up, so that it may be shaded; what lies on the ground is not
};

const Paint kPaints[] = {
    {"carpet", {35, 120, 50}, Colour::kGreen, false},
    {"line", {235, 235, 235}, Colour::kWhite, false},
    {"ball", {240, 110, 20}, Colour::kOrange, true},
    {"ball of the scenarios", {255, 102, 13}, Colour::kOrange, true},
    {"yellow goal", {230, 200, 30}, Colour::kYellow, true},
    {"blue goal", {30, 60, 190}, Colour::kBlue, true},
    {"magenta mark", {200, 30, 120}, Colour::kMagenta, true},
    {"cyan mark", {30, 170, 190}, Colour::kCyan, true},
    {"dark robot", {60, 60, 65}, Colour::kOther, true},
    {"light robot", {170, 170, 175}, Colour::kOther, true},
    {"black foot", {25, 25, 25}, Colour::kOther, true},
    {"floor", {110, 100, 90}, Colour::kOther, false},
};

/// Share of noisy pixels of this paint that get its class.
double rightShare(const Paint& paint, double gain, double shade, double noise) {
  FieldColours field;
  field.green_level = 120 * gain;
  field.green_share = (120.0 - 50) / (35 + 120 + 50);
  field.derive();
  const RandomStream random(5, paint.name, 0);
  int right = 0;
  constexpr int kPixels = 2000;
  for (std::uint64_t i = 0; i < kPixels; ++i) {
    std::uint8_t rgb[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const double level = paint.rgb[k] * gain * shade + noise * random.normal(3 * i + k) + 0.5;
      rgb[k] = static_cast<std::uint8_t>(level < 0 ? 0 : level > 255 ? 255 : level);
    }
    right += classify(rgb, field) == paint.colour ? 1 : 0;
  }
  return static_cast<double>(right) / kPixels;
}

TEST(VisionColours, AreTheSameUnderWeakAndStrongLight) {
  for (const Paint& paint : kPaints) {
    for (const double gain : {0.6, 0.8, 1.0, 1.3}) EXPECT_GT(rightShare(paint, gain, 1, 4), 0.96) << paint.name << gain;
  }
}

TEST(VisionColours, AreTheSameInShade) {
  for (const Paint& paint : kPaints) {
    if (!paint.upright) continue;
    for (const double gain : {0.6, 1.0, 1.3}) {
      EXPECT_GT(rightShare(paint, gain, 0.55, 5), 0.93) << paint.name << " at gain " << gain;
    }
  }
}

TEST(VisionColours, LightGreyIsNotWhiteUnderAnyLight) {
  for (const double gain : {0.6, 1.0, 1.3}) {
    const Paint& grey = kPaints[9];
    ASSERT_STREQ(grey.name, "light robot");
    for (const double shade : {0.55, 0.8, 1.0}) EXPECT_GT(rightShare(grey, gain, shade, 4), 0.95) << gain << shade;
  }
}

}  // namespace
}  // namespace murosimf::controllers
