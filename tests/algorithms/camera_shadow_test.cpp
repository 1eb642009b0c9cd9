/// @file Hard shadows in pictures: against closed forms, and against rays to the lamp in double precision.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "algorithms/camera_reference.h"
#include "algorithms/camera_scene.h"
#include "algorithms/mesh_shapes.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;

struct Studio {
  explicit Studio(CameraModel model = camera_scene::headCamera()) : camera(model), rays(camera) {}
  void add(const Shape& shape, const Pose& X_WS) {
    Drawable& d = scene.drawables.emplace_back();
    d.shape = shape, d.X_WS = X_WS, d.colour = {0.8F, 0.8F, 0.8F}, d.label = 5;
  }
  Picture shoot(bool shadows, CastLanes lanes = CastLanes::kWidest, bool antialias = false) {
    CastOptions options;
    options.shadows = shadows, options.lanes = lanes, options.antialias = antialias;
    PreparedScene work;
    Picture picture;
    castPicture(rays, scene, X_WC, {}, options, work, picture);
    return picture;
  }

  CameraModel camera;
  RayTable rays;
  RayScene scene;
  Pose X_WC = cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35);
};

bool isDarker(const Picture& with, const Picture& without, std::size_t i) {
  return with.rgb[3 * i + 1] < without.rgb[3 * i + 1];
}

int darkPixels(const Picture& with, const Picture& without) {
  int count = 0;
  for (std::size_t i = 0; i < with.depth.size(); ++i) count += isDarker(with, without, i);
  return count;
}

TEST(CameraShadow, OfASphereUnderTheLampIsADiscWithoutTheLampsLight) {
  Studio s(makePinholeCamera(640, 480, 1.0));
  s.scene.light_W = {0, 0, 1};
  s.scene.ambient = 0.5F;
  s.scene.ground.carpet = {0.4F, 0.8F, 0.4F};
  const double radius = 0.2, height = 3;
  s.add(makeSphere(radius), {{}, {0, 0, 1.0}});
  s.X_WC = lookAt({1.0, 0, height}, {1.0, 0, 0});  // the sphere stands aside of its shadow
  const Picture p = s.shoot(true), plain = s.shoot(false);
  const double pixel = height / s.camera.fx;
  int dark = 0;
  for (std::size_t i = 0; i < p.depth.size(); ++i) {
    if (p.label[i] != kGroundLabel || !isDarker(p, plain, i)) continue;
    ++dark;
    EXPECT_EQ(p.rgb[3 * i + 1], 102) << "half of 0.8";
  }
  EXPECT_NEAR(dark * pixel * pixel, kPi * radius * radius, 0.02 * kPi * radius * radius);
}

TEST(CameraShadow, OfAPostIsAsLongAsTheLampIsLow) {
  Studio s(makePinholeCamera(640, 480, 1.2));
  s.scene.light_W = {1, 0, 0.5};
  s.add(makeBox({0.1, 0.1, 0.6}), {{}, {0, 0, 0.3}});
  s.X_WC = lookAt({-0.6, 0, 3}, {-0.6, 0, 0});
  const Picture p = s.shoot(true), plain = s.shoot(false);
  const double pixel = 3 / s.camera.fx;
  double area = 0;
  for (std::size_t i = 0; i < p.depth.size(); ++i)
    area += isDarker(p, plain, i) && p.label[i] == kGroundLabel ? pixel * pixel : 0;
  EXPECT_NEAR(area, 0.1 * 1.2, 0.03 * 0.12) << "1.2 m long beside the post, of 0.1 m";
}

/// Whether something of the scene lies between a point and the lamp, farther than `gap` from it.
bool isBlocked(const RayScene& scene, const Vector3& p_W, const Vector3& lamp_W, double gap) {
  for (const Drawable& d : scene.drawables) {
    const Vector3 o = applyInverse(d.X_WS, p_W + lamp_W * gap), l = applyTransposed(d.X_WS.rotation, lamp_W);
    const Vector3& h = d.shape.half_size;
    Vector3 normal;
    if (camera_reference::holds(d, p_W + lamp_W * gap)) return true;
    const double t = d.shape.kind == ShapeKind::kBox         ? camera_reference::enterBox(h, o, l, normal)
                     : d.shape.kind == ShapeKind::kEllipsoid ? camera_reference::enterEllipsoid(h, o, l, normal)
                                                             : camera_reference::enterCylinder(h, o, l, normal);
    if (t > 0) return true;
  }
  return false;
}

TEST(CameraShadow, WholeGameAgreesWithRaysToTheLampInDoublePrecision) {
  for (const double heading : {0.25, 2.9}) {
    Studio s;
    s.scene = camera_scene::makeGame();
    s.X_WC = cameraPose({-0.9, -0.5, 0.7}, heading, 0.35);
    const Picture p = s.shoot(true), plain = s.shoot(false);
    const Vector3 lamp_W = normalized(s.scene.light_W);
    int wrong = 0, dark = 0, on_things = 0;
    for (int v = 0; v < 480; v += 2)
      for (int u = 0; u < 640; u += 2) {
        const std::size_t i = p.index(u, v);
        EXPECT_EQ(p.label[i], plain.label[i]);
        if (p.label[i] == kSkyLabel || p.depth[i] > 30) continue;
        const RaySlopes r = s.rays.ray(u, v);
        const camera_reference::Hit hit = camera_reference::cast(s.scene, s.X_WC, r.x, r.y);
        if (dot(hit.normal_W, lamp_W) < 0.05) continue;  // turned away: dark by itself
        const Vector3 p_W = s.X_WC * (Vector3{r.x, r.y, 1} * double(p.depth[i]));
        const bool blocked = isBlocked(s.scene, p_W, lamp_W, 2.5e-3);
        wrong += blocked != isDarker(p, plain, i);
        dark += blocked, on_things += blocked && p.label[i] != kGroundLabel;
      }
    EXPECT_GT(dark, 800) << heading;
    EXPECT_GT(on_things, 100) << heading;
    EXPECT_LT(wrong, 0.03 * dark) << heading;  // on the edges of shadows
  }
}

TEST(CameraShadow, MeshesThrowThemAsTheirPrimitivesDo) {
  Studio s;
  s.scene = camera_scene::makeGame();
  const int expected = darkPixels(s.shoot(true), s.shoot(false));
  mesh_shapes::drawAsMeshes(64, s.scene);
  EXPECT_NEAR(darkPixels(s.shoot(true), s.shoot(false)), expected, 0.03 * expected);
}

TEST(CameraShadow, OfACapsuleIsThatOfACylinderAndTwoSpheres) {
  Studio s;
  const Pose X_WS{rotationX(0.8), {0.5, 0.2, 0.3}};
  s.add(makeCapsule(0.05, 0.2), X_WS);
  const Picture whole = s.shoot(true), plain = s.shoot(false);
  s.scene.drawables.clear();
  s.add(makeCylinder(0.05, 0.2), X_WS);
  s.add(makeSphere(0.05), {{}, X_WS * Vector3{0, 0, -0.1}});
  s.add(makeSphere(0.05), {{}, X_WS * Vector3{0, 0, 0.1}});
  const Picture parts = s.shoot(true);
  int different = 0;
  for (std::size_t i = 0; i < whole.rgb.size(); ++i) different += std::abs(whole.rgb[i] - parts.rgb[i]) > 1;
  EXPECT_LT(different, 60);
  EXPECT_GT(darkPixels(whole, plain), 500);
}

TEST(CameraShadow, PicturesAreTheSameForAnyNumberOfLanesAndAnyCuttingIntoTiles) {
  for (const bool antialias : {false, true}) {
    Studio s(camera_scene::headCamera(321, 243));
    s.scene = camera_scene::makeGame();
    for (std::size_t i = 0; i < s.scene.drawables.size(); i += 3) {
      RayScene one;
      one.drawables = {s.scene.drawables[i]};
      mesh_shapes::drawAsMeshes(16, one);
      s.scene.drawables[i] = one.drawables[0];
    }
    const Picture one = s.shoot(true, CastLanes::kOne, antialias);
    for (const CastLanes lanes : {CastLanes::kEight, CastLanes::kWidest}) {
      const Picture p = s.shoot(true, lanes, antialias);
      EXPECT_EQ(p.rgb, one.rgb);
      EXPECT_EQ(p.label, one.label);
    }
  }
}

TEST(CameraShadow, EdgesAreSmoothWithFourSamples) {
  Studio s;
  s.add(makeSphere(0.15), {{}, {0.6, 0.1, 0.6}});
  const Picture hard = s.shoot(true), smooth = s.shoot(true, CastLanes::kWidest, true), plain = s.shoot(false);
  int between = 0;
  for (std::size_t i = 0; i < hard.depth.size(); ++i) {
    if (hard.label[i] != kGroundLabel) continue;
    const bool darkest = smooth.rgb[3 * i + 1] == hard.rgb[3 * i + 1],
               lightest = smooth.rgb[3 * i + 1] == plain.rgb[3 * i + 1];
    between += !darkest && !lightest;
  }
  EXPECT_GT(between, 100);
}

TEST(CameraShadow, HiddenDrawablesThrowThemToo) {
  Studio s;
  s.scene.drawables.push_back(camera_scene::place(makeSphere(0.1), {{}, {0.5, 0, 0.3}}, {1, 1, 1}, 5, 77));
  const std::uint32_t hidden[] = {77};
  CastOptions options;
  PreparedScene work;
  Picture with, without;
  castPicture(s.rays, s.scene, s.X_WC, hidden, options, work, without);
  options.shadows = true;
  castPicture(s.rays, s.scene, s.X_WC, hidden, options, work, with);
  EXPECT_EQ(std::count(with.label.begin(), with.label.end(), 5), 0);
  EXPECT_GT(darkPixels(with, without), 300);
}

}  // namespace
}  // namespace murosimf
