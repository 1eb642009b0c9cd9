#include "murosimf/soccer/label_blob.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace murosimf {
namespace {

Picture labelled(int width, int height) {
  Picture picture;
  picture.resize(width, height);
  return picture;
}

TEST(LabelBlob, CentreAndRadiusOfADisc) {
  Picture picture = labelled(640, 480);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 640; ++u) {
      const double x = u - 211.0, y = v - 97.0;
      if (x * x + y * y < 20.5 * 20.5) picture.label[picture.index(u, v)] = 7;
    }
  }
  const LabelBlob blob = findLabel(picture, 7);
  EXPECT_NEAR(blob.u, 211, 1e-12);
  EXPECT_NEAR(blob.v, 97, 1e-12);
  EXPECT_NEAR(blob.radius(), 20.5, 0.1);
  EXPECT_EQ(findLabel(picture, 8).pixels, 0);
}

TEST(LabelBlob, NothingInAPictureWithoutLabels) {
  Picture picture;
  picture.has_label = false;
  picture.resize(64, 48);
  EXPECT_EQ(findLabel(picture, 1).pixels, 0);
}

RC_GTEST_PROP(LabelBlob, EqualsCountingPixelByPixel, ()) {
  Picture picture = labelled(*rc::gen::inRange(1, 70), *rc::gen::inRange(1, 9));
  const std::uint16_t labels[] = {0, 1, 2, 3, 0x0100, 0x8000, 0x7fff, 0xffff};
  const auto label = labels[*rc::gen::inRange(0, 8)];
  for (auto& pixel : picture.label) pixel = labels[*rc::gen::inRange(0, 8)];
  long pixels = 0;
  double u = 0, v = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.label[picture.index(x, y)] == label) ++pixels, u += x, v += y;
    }
  }
  const LabelBlob blob = findLabel(picture, label);
  RC_ASSERT(blob.pixels == pixels);
  if (pixels == 0) return;
  RC_ASSERT(std::fabs(blob.u - u / static_cast<double>(pixels)) < 1e-9);
  RC_ASSERT(std::fabs(blob.v - v / static_cast<double>(pixels)) < 1e-9);
}

}  // namespace
}  // namespace murosimf
