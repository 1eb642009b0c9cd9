/// The vision undoes the lens: against the forward formula, and against another method of inversion.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "algorithms/lenses.h"
#include "controllers/picture_synthesiser.h"
#include "player/vision/ray_table.h"

namespace murosimf::controllers {
namespace {

TEST(VisionLens, RayOfAPixelFallsOnThatPixelAgain) {
  for (const client::CameraDescription& camera : {test::headCamera(), test::chestCamera()}) {
    for (int v = -1; v <= camera.height; v += 7) {
      for (int u = -1; u <= camera.width; u += 7) {
        const PixelPoint back = toPixel(camera, toRay(camera, {double(u), double(v)}));
        ASSERT_NEAR(back.u, u, 1e-9) << camera.name;
        ASSERT_NEAR(back.v, v, 1e-9) << camera.name;
      }
    }
  }
}

TEST(VisionLens, WithoutDistortionIsAPinhole) {
  client::CameraDescription camera = test::headCamera();
  for (double& k : camera.kc) k = 0;
  const PlanePoint p = toRay(camera, {camera.cx + 100, camera.cy - 50});
  EXPECT_DOUBLE_EQ(p.a, 100 / camera.fx);
  EXPECT_DOUBLE_EQ(p.b, -50 / camera.fy);
}

TEST(VisionLens, NewtonAgreesWithFixedPointIteration) {
  for (const client::CameraDescription& camera : {test::headCamera(), test::chestCamera()}) {
    const test::SyntheticCamera other(camera);
    for (int v = 0; v < camera.height; v += 13) {
      for (int u = 0; u < camera.width; u += 13) {
        const PlanePoint p = toRay(camera, {double(u), double(v)});
        ASSERT_NEAR(p.a, other.ray(u, v).x, 1e-9);
        ASSERT_NEAR(p.b, other.ray(u, v).y, 1e-9);
      }
    }
  }
}

TEST(VisionLens, JacobianIsTheDerivativeOfTheLens) {
  const double h = 1e-6;
  client::CameraDescription camera;
  const double kc[] = {-0.35, 0.15, 0.002, -0.001, -0.02};
  std::copy(std::begin(kc), std::end(kc), camera.kc);
  for (const PlanePoint p : {PlanePoint{0.3, -0.2}, {-0.8, 0.6}, {0, 0}, {1.1, 0.1}}) {
    const DistortedPoint d = distort(camera, p);
    const PlanePoint a1 = distort(camera, {p.a + h, p.b}).point, a0 = distort(camera, {p.a - h, p.b}).point;
    const PlanePoint b1 = distort(camera, {p.a, p.b + h}).point, b0 = distort(camera, {p.a, p.b - h}).point;
    EXPECT_NEAR(d.da_da, (a1.a - a0.a) / (2 * h), 1e-8);
    EXPECT_NEAR(d.db_da, (a1.b - a0.b) / (2 * h), 1e-8);
    EXPECT_NEAR(d.da_db, (b1.a - b0.a) / (2 * h), 1e-8);
    EXPECT_NEAR(d.db_db, (b1.b - b0.b) / (2 * h), 1e-8);
  }
}

client::CameraDescription descriptionOf(const CameraModel& m) {
  client::CameraDescription c;
  c.width = m.width, c.height = m.height;
  c.fx = m.fx, c.fy = m.fy, c.cx = m.cx, c.cy = m.cy, c.skew = m.skew;
  c.lens = m.kind == LensKind::kFisheye ? client::LensKind::kFisheye : client::LensKind::kRational;
  std::copy(m.kc.begin(), m.kc.end(), c.kc);
  c.linear_from = m.linear_from;
  return c;
}

TEST(VisionLens, AgreesWithTheSimulatorsForTwentyLensesOfEveryKind) {
  for (const auto& [name, model] : lenses::all()) {
    const client::CameraDescription camera = descriptionOf(model);
    for (int row = 0; row <= 20; ++row) {
      for (int column = 0; column <= 20; ++column) {
        const PixelPoint place{column * (camera.width - 1) / 20.0, row * (camera.height - 1) / 20.0};
        const PlanePoint p = toRay(camera, place);
        const RaySlopes wanted = unproject(model, {place.u, place.v});
        const double size = 1 + std::hypot(wanted.x, wanted.y);
        ASSERT_NEAR(p.a, wanted.x, 1e-9 * size * size) << name << " at " << place.u << ", " << place.v;
        ASSERT_NEAR(p.b, wanted.y, 1e-9 * size * size) << name << " at " << place.u << ", " << place.v;
        const DistortionJacobian j = distortionJacobian(model, wanted);
        const DistortedPoint d = distort(camera, p);
        ASSERT_NEAR(d.da_db, j.xy, 1e-8) << name;
        ASSERT_NEAR(d.db_da, j.yx, 1e-8) << name;
        ASSERT_NEAR(d.determinant(), j.xx * j.yy - j.xy * j.yx, 1e-8) << name;
      }
    }
  }
}

TEST(VisionLens, TableOfRaysIsWithinATwentiethOfAPixel) {
  for (const client::CameraDescription& camera : {test::headCamera(), test::chestCamera()}) {
    RayTable table;
    table.start(camera);
    double worst = 0;
    for (double v = 0; v < camera.height - 1; v += 3.7) {
      for (double u = 0; u < camera.width - 1; u += 3.7) {
        const PixelPoint back = toPixel(camera, table.ray(u, v));
        worst = std::max({worst, abs(back.u - u), abs(back.v - v)});
      }
    }
    EXPECT_LT(worst, 1.0 / 20) << camera.name;
    EXPECT_GT(worst, 1e-7) << "a table that is exact between its nodes is no table";
  }
}

}  // namespace
}  // namespace murosimf::controllers
