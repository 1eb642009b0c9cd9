#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/camera_reference.h"
#include "algorithms/camera_scene.h"
#include "book/page.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;

/// A camera 1 m above the ground that looks along x, and a scene with one drawable or none.
struct Studio {
  explicit Studio(CameraModel model = makePinholeCamera(640, 480, 1.0)) : camera(model), rays(camera) {}
  void add(const Shape& shape, const Pose& X_WS, int label = 5, unsigned owner = 0) {
    scene.drawables.push_back(camera_scene::place(shape, X_WS, {0.8F, 0.4F, 0.2F}, label, owner));
  }
  void shoot(std::span<const std::uint32_t> hidden = {}) {
    castPicture(rays, scene, X_WC, hidden, options, work, picture);
  }
  int labelAt(int u, int v) const { return picture.label[picture.index(u, v)]; }
  double depthAt(int u, int v) const { return picture.depth[picture.index(u, v)]; }
  int count(int label) const { return int(std::count(picture.label.begin(), picture.label.end(), label)); }

  CameraModel camera;
  RayTable rays;
  RayScene scene;
  Pose X_WC = cameraPose({0, 0, 1}, 0, 0);
  CastOptions options;
  PreparedScene work;
  Picture picture;
};

TEST(CameraPicture, LeftIsLeftAndUpIsUp) {
  Studio s;
  s.add(makeSphere(0.1), {{}, {2, 0.4, 1}}, 1);   // y > 0: left
  s.add(makeSphere(0.1), {{}, {2, -0.4, 1}}, 2);  // right
  s.add(makeSphere(0.1), {{}, {2, 0, 1.4}}, 3);   // above
  s.shoot();
  const int away = int(0.2 * s.camera.fx);
  EXPECT_EQ(s.labelAt(320 - away, 240), 1);
  EXPECT_EQ(s.labelAt(320 + away, 240), 2);
  EXPECT_EQ(s.labelAt(320, 240 - away), 3);
  EXPECT_EQ(s.labelAt(320, 0), kSkyLabel);
  EXPECT_EQ(s.labelAt(320, 479), kGroundLabel);
  EXPECT_TRUE(std::isinf(s.depthAt(0, 0)));
}

TEST(CameraPicture, GroundHasTheDepthOfThePlane) {
  Studio s;
  const double pitch = 0.4;
  s.X_WC = cameraPose({0.3, -0.2, 0.45}, 0.7, pitch);
  s.shoot();
  book::Page page({book::Chapter::kPictures,
                   "The ground has the depth of the plane",
                   R"(d = \frac{h}{\sin\theta + y \cos\theta})",
                   "Intersection of ray and plane",
                   {{"h", "height of the camera, here 0.45", "m"},
                    {"\\theta", "pitch, here 0.4", "rad"},
                    {"y", "slope of the row's rays", ""}},
                   {"row", "px"},
                   {"depth $d$", "m", true}});
  page.curve(50, 479,
             [&](double v) { return 0.45 / (std::sin(pitch) + (v - s.camera.cy) / s.camera.fy * std::cos(pitch)); });
  int seen = 0;
  for (int v = 0; v < 480; v += 7)
    for (int u = 0; u < 640; u += 11) {
      const double y = (v - s.camera.cy) / s.camera.fy, sink = std::sin(pitch) + y * std::cos(pitch);
      if (sink < 1e-3) continue;
      ++seen;
      if (u == 0) {
        EXPECT_TRUE(page.near(v, s.depthAt(u, v), 0.45 / sink, 1e-5 * 0.45 / sink));
      }
      EXPECT_NEAR(s.depthAt(u, v), 0.45 / sink, 1e-5 * 0.45 / sink);
    }
  EXPECT_GT(seen, 1000);
}

TEST(CameraPicture, SphereOnTheAxisHasTheAreaAndDepthOfItsCone) {
  book::Page page({book::Chapter::kPictures,
                   "A sphere on the axis has the area of its cone in the picture",
                   R"(A = \pi f^2 \frac{r^2}{d^2 - r^2})",
                   "Tangent cone of a sphere",
                   {{"r", "radius, here 0.2", "m"}, {"f", "focal length", "px"}},
                   {"distance $d$", "m"},
                   {"area $A$", "px"}});
  for (const double distance : {0.75, 1.0, 1.5}) {
    Studio s;
    const double radius = 0.2;
    s.add(makeSphere(radius), {{}, {distance, 0, 1}});
    s.shoot();
    const auto area = [&](double d) { return kPi * s.camera.fx * s.camera.fx / (d * d / (radius * radius) - 1); };
    const double extent = s.camera.fx * radius / std::sqrt(distance * distance - radius * radius);
    page.curve(0.7, 1.6, area);
    EXPECT_TRUE(page.near(distance, s.count(5), area(distance), 0.002 * area(distance)));
    EXPECT_EQ(s.labelAt(int(std::floor(s.camera.cx + extent)), 240), 5);
    EXPECT_NE(s.labelAt(int(std::ceil(s.camera.cx + extent)) + 1, 240), 5);
    EXPECT_NEAR(s.depthAt(320, 240), distance - radius, 1e-3);
  }
}

TEST(CameraPicture, EveryPixelOfASphereLiesInItsCone) {
  Studio s(camera_scene::headCamera());
  const Vector3 middle_W{1.2, 0.35, 0.75};
  const double radius = 0.15;
  s.add(makeSphere(radius), {rotationX(1.0), middle_W});
  s.shoot();
  const Vector3 p_C = applyInverse(s.X_WC, middle_W);
  const double cosine = std::sqrt(1 - radius * radius / squaredNorm(p_C));
  int inside = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const RaySlopes r = s.rays.ray(u, v);
      const double c = dot(normalized(Vector3{r.x, r.y, 1}), normalized(p_C));
      if (std::fabs(c - cosine) < 1e-6) continue;
      EXPECT_EQ(s.labelAt(u, v) == 5, c > cosine) << u << " " << v;
      inside += c > cosine;
    }
  EXPECT_GT(inside, 5000);
}

TEST(CameraPicture, BoxSeenFromTheFrontIsARectangleOfOneDepth) {
  Studio s;
  s.add(makeBox({0.4, 0.6, 0.3}), {{}, {2.2, 0, 1}});  // front face at x = 2
  s.shoot();
  const double half_width = s.camera.fx * 0.3 / 2.0, half_height = s.camera.fy * 0.15 / 2.0;
  int count = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const bool inside = std::fabs(u - s.camera.cx) < half_width && std::fabs(v - s.camera.cy) < half_height;
      EXPECT_EQ(s.labelAt(u, v) == 5, inside);
      if (!inside) continue;
      ++count;
      EXPECT_NEAR(s.depthAt(u, v), 2.0, 1e-6);
    }
  EXPECT_GT(count, 10000);
}

TEST(CameraPicture, UprightCylinderHasStraightEdgesAtItsTangents) {
  Studio s;
  const double distance = 2.0, radius = 0.1;
  s.add(makeCylinder(radius, 0.8), {{}, {distance, 0, 1}});
  s.shoot();
  const double extent = s.camera.fx * radius / std::sqrt(distance * distance - radius * radius);
  for (int v = 160; v < 320; ++v) {
    for (int u = 0; u < 640; ++u) EXPECT_EQ(s.labelAt(u, v) == 5, std::fabs(u - s.camera.cx) < extent) << u << " " << v;
    EXPECT_NEAR(s.depthAt(320, v), distance - radius, 1e-3);
  }
}

TEST(CameraPicture, CylinderShowsItsCapToACameraAboveIt) {
  Studio s;
  s.X_WC = lookAt({0, 0, 3}, {0, 0, 0});
  s.add(makeCylinder(0.2, 1.0), {{}, {0, 0, 0.5}});
  s.shoot();
  EXPECT_NEAR(s.depthAt(320, 240), 2.0, 1e-5);
  const double extent = s.camera.fx * 0.2 / 2.0;  // the cap hides the side
  EXPECT_NEAR(s.count(5), kPi * extent * extent, 0.005 * kPi * extent * extent);
}

TEST(CameraPicture, LightFollowsTheNormal) {
  Studio s;
  s.scene.light_W = {0, 0, 2};  // of any length
  s.scene.ambient = 0.25F;
  s.add(makeBox({0.2, 0.2, 0.2}), {{}, {0, 0, 0.1}});
  s.X_WC = lookAt({0, 0, 1}, {0, 0, 0});
  s.shoot();
  EXPECT_EQ(s.picture.rgb[3 * s.picture.index(320, 240)], 204);  // top: full light, 0.8 * 255
  s.X_WC = cameraPose({-1, 0, 0.1}, 0, 0);
  s.shoot();
  EXPECT_EQ(s.picture.rgb[3 * s.picture.index(320, 240)], 51);  // side: a quarter
  EXPECT_EQ(s.picture.rgb[3 * s.picture.index(320, 240) + 2], 13);
}

TEST(CameraPicture, GroundBrightnessAndGainScaleTheBytes) {
  Studio s;
  s.scene.ambient = 1.0F;
  s.scene.ground.carpet = {0.2F, 0.4F, 0.1F};
  s.X_WC = lookAt({0, 0, 1}, {0, 0, 0});
  s.scene.ground.brightness = 1.5F;
  s.options.sensor.gain = 0.5F;
  s.shoot();
  EXPECT_EQ(s.picture.rgb[0], std::lround(255 * 0.2 * 0.75));
  EXPECT_EQ(s.picture.rgb[1], std::lround(255 * 0.4 * 0.75));
}

TEST(CameraPicture, WhatIsHiddenBehindOrAroundTheCameraIsNotDrawn) {
  Studio s;
  s.add(makeSphere(0.3), {{}, {-2, 0, 1}}, 1);            // behind
  s.add(makeBox({0.5, 0.5, 0.5}), {{}, {0.1, 0, 1}}, 2);  // around
  s.add(makeCylinder(0.5, 0.5), {{}, {0.1, 0, 1}}, 3);    // around
  s.add(makeSphere(0.4), {{}, {0.1, 0, 1}}, 4);           // around
  s.add(makeSphere(0.2), {{}, {1, 0, 1}}, 5, 77);
  s.shoot();
  for (const int label : {1, 2, 3, 4}) EXPECT_EQ(s.count(label), 0) << label;
  EXPECT_GT(s.count(5), 100);
  const std::uint32_t hidden[] = {3, 77};
  s.shoot(hidden);
  EXPECT_EQ(s.count(5), 0);
}

TEST(CameraPicture, ThingsBesideTheCameraThatReachBehindItAreSeenInFront) {
  Studio s(camera_scene::headCamera());
  s.add(makeBox({1.0, 0.1, 0.1}), {{}, {0.3, 0.3, 0.9}}, 1);
  s.add(makeCylinder(0.05, 1.0), {rotationY(0.5 * kPi), {0.3, -0.3, 0.9}}, 2);
  s.add(makeEllipsoid({0.8, 0.2, 0.05}), {{}, {0.3, 0, 0.7}}, 3);
  s.shoot();
  int wrong = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const RaySlopes r = s.rays.ray(u, v);
      wrong += camera_reference::cast(s.scene, s.X_WC, r.x, r.y).label != s.labelAt(u, v);
    }
  for (const int label : {1, 2, 3}) EXPECT_GT(s.count(label), 300) << label;
  EXPECT_LT(wrong, 10);
}

TEST(CameraPicture, WholeGameAgreesWithASlowCasterInDoublePrecision) {
  for (const double heading : {0.25, 2.9, -1.2}) {
    Studio s(camera_scene::headCamera());
    s.scene = camera_scene::makeGame();
    s.X_WC = cameraPose({-0.35, -0.2, 0.5}, heading, 0.35);
    s.shoot();
    int wrong = 0, compared = 0;
    double worst = 0;
    for (int v = 0; v < 480; v += 2)
      for (int u = 0; u < 640; u += 2) {
        const RaySlopes r = s.rays.ray(u, v);
        const camera_reference::Hit hit = camera_reference::cast(s.scene, s.X_WC, r.x, r.y);
        if (hit.label != s.labelAt(u, v)) {
          ++wrong;
        } else if (hit.label != kSkyLabel && hit.depth < 30) {
          ++compared;
          if (std::fabs(s.depthAt(u, v) / hit.depth - 1) > 1e-4)
            ++wrong;
          else
            worst = std::max(worst, std::fabs(s.depthAt(u, v) / hit.depth - 1));
        }
      }
    EXPECT_GT(compared, 50000);
    EXPECT_LT(wrong, 40) << heading;  // of 76 800: pixels on edges
    EXPECT_LT(worst, 1e-4);
  }
}

TEST(CameraPicture, DistortedPictureIsThePinholePictureSampledWhereItsRaysFall) {
  Studio lens(camera_scene::headCamera()), pinhole(makePinholeCamera(1280, 960, 1.4));
  lens.scene = pinhole.scene = camera_scene::makeGame();
  lens.X_WC = pinhole.X_WC = cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35);
  lens.shoot(), pinhole.shoot();
  int same = 0, all = 0, moved = 0;
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const ImagePoint place = project(pinhole.camera, unproject(lens.camera, {double(u), double(v)}));
      ASSERT_TRUE(isInPicture(pinhole.camera, place));
      ++all;
      same += lens.labelAt(u, v) == pinhole.labelAt(int(std::lround(place.u)), int(std::lround(place.v)));
      moved += std::fabs((place.u - pinhole.camera.cx) * lens.camera.fx / pinhole.camera.fx + lens.camera.cx - u) > 5;
    }
  EXPECT_GT(same, 0.99 * all);
  EXPECT_GT(moved, 0.3 * all);  // it is another picture
}

TEST(CameraPicture, OddSizesAreFilledToTheLastPixel) {
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 15}, {33, 50}, {100, 75}}) {
    Studio s(makePinholeCamera(width, height, 0.9)), big(makePinholeCamera(width + 64, height + 64, 0.9));
    s.scene = big.scene = camera_scene::makeGame();
    s.X_WC = cameraPose({-0.35, -0.2, 0.5}, 0.25, 0.35);
    s.picture.resize(width, height);
    std::fill(s.picture.depth.begin(), s.picture.depth.end(), -1.0F);
    s.shoot();
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) {
        const RaySlopes r = s.rays.ray(u, v);
        EXPECT_EQ(s.labelAt(u, v), camera_reference::cast(s.scene, s.X_WC, r.x, r.y).label);
        EXPECT_GT(s.depthAt(u, v), 0.0);
      }
  }
}

TEST(CameraPicture, DepthAndLabelAreLeftOutWhenNotWanted) {
  Studio s;
  s.picture.has_depth = s.picture.has_label = false;
  s.shoot();
  EXPECT_TRUE(s.picture.depth.empty() && s.picture.label.empty());
  EXPECT_EQ(s.picture.rgb.size(), 640U * 480U * 3U);
}

TEST(CameraPicture, FourSamplesBringTheSilhouettesAreaAndLeaveDepthAndLabel) {
  Studio s;
  s.scene.ambient = 1.0F;
  s.scene.sky = s.scene.ground.surroundings = s.scene.ground.carpet = {0, 0, 0};
  const double distance = 6.0, radius = 0.05;
  s.add(makeSphere(radius), {{}, {distance, 0.01, 1.013}});
  s.scene.drawables[0].colour = {1, 1, 1};
  const double extent = s.camera.fx * radius / std::sqrt(distance * distance - radius * radius);
  const double area = kPi * extent * extent;  // some 60 pixels
  const auto shownArea = [&] {
    double sum = 0;
    for (const std::uint8_t byte : s.picture.rgb) sum += byte;
    return sum / (3 * 255);
  };
  s.shoot();
  const Picture plain = s.picture;
  s.options.antialias = true;
  s.shoot();
  EXPECT_NEAR(shownArea(), area, 0.03 * area);
  EXPECT_EQ(s.picture.label, plain.label);
  EXPECT_EQ(s.picture.depth, plain.depth);
  int grey = 0;
  for (const std::uint8_t byte : s.picture.rgb) grey += byte != 0 && byte != 255;
  EXPECT_GT(grey, 30);
}

TEST(CameraPicture, ShadowsDarkenTheGroundBeneathThingsOnly) {
  Studio s;
  s.X_WC = lookAt({-1, 0, 1}, {0, 0, 0});
  s.add(makeSphere(0.05), {{}, {0, 0, 0.05}});
  s.shoot();
  const Picture plain = s.picture;
  s.scene.ground_shadows = true;
  s.shoot();
  int darker = 0;
  for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
    EXPECT_LE(s.picture.rgb[i], plain.rgb[i]);
    if (s.picture.rgb[i] == plain.rgb[i]) continue;
    ++darker;
    EXPECT_EQ(plain.label[i / 3], kGroundLabel);
  }
  EXPECT_GT(darker, 500);
  EXPECT_LT(darker, 60000);
}

}  // namespace
}  // namespace murosimf
