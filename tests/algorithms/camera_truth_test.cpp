/// @file What a picture tells besides colour: parts, boxes, lines, motion; each against a second way to it.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "algorithms/camera_scene.h"
#include "algorithms/mesh_shapes.h"
#include "murosimf/algorithms/label_boxes.h"
#include "murosimf/algorithms/pixel_motion.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;

struct Studio {
  explicit Studio(CameraModel model = camera_scene::headCamera()) : camera(model), rays(camera) {
    scene = camera_scene::makeGame();
    picture.has_part = picture.has_boxes = true;
  }
  void shoot(const CastOptions& options = {}) { castPicture(rays, scene, X_WC, {}, options, work, picture); }

  CameraModel camera;
  RayTable rays;
  RayScene scene;
  Pose X_WC = cameraPose({-0.9, -0.5, 0.7}, 0.25, 0.35);
  PreparedScene work;
  Picture picture;
};

TEST(CameraTruth, BoxesAreThoseOfTheLabelPicture) {
  for (const int width : {640, 131}) {
    Studio s(camera_scene::headCamera(width, 3 * width / 4));
    s.shoot();
    std::map<int, LabelBox> expected;
    for (int v = 0; v < s.picture.height; ++v)
      for (int u = 0; u < s.picture.width; ++u) {
        const std::uint16_t label = s.picture.label[s.picture.index(u, v)];
        if (label == kGroundLabel || label == kSkyLabel) continue;
        LabelBox& box = expected.try_emplace(label, LabelBox{label, u, v, u, v, 0}).first->second;
        box.u_low = std::min(box.u_low, u), box.u_high = std::max(box.u_high, u);
        box.v_low = std::min(box.v_low, v), box.v_high = std::max(box.v_high, v);
        ++box.pixels;
      }
    ASSERT_EQ(s.picture.boxes.size(), expected.size());
    EXPECT_GE(expected.size(), 4U);
    std::size_t i = 0;
    for (const auto& [label, box] : expected) EXPECT_EQ(s.picture.boxes[i++], box) << label;
  }
}

TEST(CameraTruth, BoxesBringLabelsThatWereNotAskedFor) {
  Studio s;
  s.picture.has_label = false;
  s.shoot();
  EXPECT_FALSE(s.picture.boxes.empty());
}

TEST(CameraTruth, PartsAreTheDrawablesThatHaveTheLabelsSeen) {
  Studio s;
  for (Drawable& d : s.scene.drawables) d.owner = 0;
  s.scene.drawables[5].owner = 3;
  for (const bool shadows : {false, true}) {
    CastOptions options;
    options.shadows = shadows;
    const std::uint32_t hidden[] = {3};
    castPicture(s.rays, s.scene, s.X_WC, hidden, options, s.work, s.picture);
    std::map<int, int> seen;
    for (std::size_t i = 0; i < s.picture.part.size(); ++i) {
      const int part = s.picture.part[i];
      ++seen[part];
      const int label = part == kSkyPart      ? kSkyLabel
                        : part == kGroundPart ? kGroundLabel
                                              : s.scene.drawables[std::size_t(part)].label;
      ASSERT_EQ(label, s.picture.label[i]);
    }
    EXPECT_GT(seen.size(), 40U);
    EXPECT_EQ(seen.count(5), 0U);
  }
}

TEST(CameraTruth, PartsAreTheSameForAnyNumberOfLanes) {
  Studio one, many;
  CastOptions options;
  options.shadows = options.antialias = true;
  many.shoot(options);
  options.lanes = CastLanes::kOne;
  one.shoot(options);
  EXPECT_EQ(one.picture.part, many.picture.part);
}

TEST(CameraTruth, LinesAreGroundThatIsPaintedByHalf) {
  Studio s;
  s.scene.drawables.clear();
  s.scene.ambient = 1, s.scene.ground.brightness = 1;
  s.scene.ground.carpet = s.scene.ground.surroundings = {0, 0, 0}, s.scene.ground.paint = {1, 1, 1};
  s.picture.marks_lines = true;
  s.shoot();
  int lines = 0;
  for (std::size_t i = 0; i < s.picture.label.size(); ++i) {
    const int byte = s.picture.rgb[3 * i];
    if (s.picture.label[i] == kSkyLabel || (byte > 126 && byte < 129)) continue;
    EXPECT_EQ(s.picture.label[i] == kLineLabel, byte >= 128);
    lines += s.picture.label[i] == kLineLabel;
  }
  EXPECT_GT(lines, 3000);
  EXPECT_TRUE(s.picture.boxes.empty()) << "lines are no things";
}

TEST(CameraTruth, MotionIsThatOfKnownPointsThroughTheLens) {
  Studio s;
  const Pose X_WC_before = cameraPose({-0.93, -0.47, 0.69}, 0.22, 0.36);
  std::vector<Pose> before;
  for (std::size_t i = 0; i < s.scene.drawables.size(); ++i) {
    const Pose moved{fromRollPitchYaw(Vector3{0.02, -0.03, 0.05}), {0.01, -0.02, 0.015}};
    before.push_back(i % 2 == 0 ? s.scene.drawables[i].X_WS : s.scene.drawables[i].X_WS * moved);
  }
  s.shoot();
  findMotion(s.rays, s.scene, s.X_WC, before, X_WC_before, s.picture);
  // Points fixed to drawables, wherever they are seen: their motion is that of the pixel in which they are seen.
  int compared = 0;
  for (std::size_t i = 0; i < s.picture.part.size(); i += 97) {
    const int part = s.picture.part[i];
    const int u = int(i) % s.picture.width, v = int(i) / s.picture.width;
    const RaySlopes r = s.rays.ray(u, v);
    if (part == kSkyPart || s.picture.depth[i] > 20) continue;
    const Vector3 p_W = s.X_WC * (Vector3{r.x, r.y, 1} * double(s.picture.depth[i]));
    const Vector3 was_W =
        part == kGroundPart ? p_W
                            : before[std::size_t(part)] * applyInverse(s.scene.drawables[std::size_t(part)].X_WS, p_W);
    const std::optional<ImagePoint> now = projectPoint(s.camera, applyInverse(s.X_WC, p_W));
    const std::optional<ImagePoint> was = projectPoint(s.camera, applyInverse(X_WC_before, was_W));
    ASSERT_TRUE(now && was);
    ++compared;
    EXPECT_NEAR(s.picture.motion[i].u, now->u - was->u, 1e-2);
    EXPECT_NEAR(s.picture.motion[i].v, now->v - was->v, 1e-2);
  }
  EXPECT_GT(compared, 1500);
}

TEST(CameraTruth, MotionOfAStillWorldIsNoneAndOfATurningCameraIsThatOfTheSky) {
  Studio s;
  std::vector<Pose> before;
  for (const Drawable& d : s.scene.drawables) before.push_back(d.X_WS);
  s.X_WC = cameraPose({-0.9, -0.5, 0.7}, 0.25, -0.1);
  s.shoot();
  findMotion(s.rays, s.scene, s.X_WC, before, s.X_WC, s.picture);
  for (const PixelMotion& m : s.picture.motion) ASSERT_LT(std::hypot(m.u, m.v), 2e-3);
  const double turn = 0.01;
  findMotion(s.rays, s.scene, s.X_WC, before, cameraPose({-5, 3, 0.7}, 0.25 - turn, -0.1), s.picture);
  const std::size_t middle = s.picture.index(320, 20);
  ASSERT_EQ(s.picture.part[middle], kSkyPart);
  EXPECT_NEAR(s.picture.motion[middle].u, s.camera.fx * turn, 1.5) << "turned left: the sky moves right";
  s.picture.depth.clear();
  EXPECT_THROW(findMotion(s.rays, s.scene, s.X_WC, before, s.X_WC, s.picture), std::invalid_argument);
}

}  // namespace
}  // namespace murosimf
