// Pictures of robots' cameras through OpenGL, against the ray caster's.

#include <cmath>

#include "algorithms/camera_scene.h"
#include "algorithms/lenses.h"
#include "algorithms/mesh_shapes.h"
#include "murosimf/render/gl/gl_camera_renderer.h"
#include "murosimf/render/gl/gl_context.h"
#include "murosimf/render/mesh_refinement.h"
#include "murosimf/simulation/png_writer.h"
#include "render/drawn_game.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;
using test::DrawnGame;

/// What two pictures have in common.
struct Agreement {
  double labels = 0;       ///< share of pixels with the same label
  double depths = 0;       ///< of these that are not the sky, share within 1 %
  double colours = 0;      ///< of these, share within 8 of 255 in all channels
  std::size_t things = 0;  ///< pixels of the first that show neither ground nor sky
};

bool sameColour(const Picture& a, const Picture& b, std::size_t i) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(int{a.rgb[3 * i + k]} - int{b.rgb[3 * i + k]}) > 8) return false;
  return true;
}

Agreement compare(const Picture& truth, const Picture& seen) {
  Agreement a;
  double equal = 0, compared = 0, near = 0, alike = 0;
  for (std::size_t i = 0; i < truth.label.size(); ++i) {
    if (truth.label[i] != kGroundLabel && truth.label[i] != kSkyLabel) ++a.things;
    if (truth.label[i] != seen.label[i]) continue;
    ++equal;
    alike += sameColour(truth, seen, i) ? 1 : 0;
    if (truth.label[i] == kSkyLabel) continue;
    ++compared;
    near += std::fabs(seen.depth[i] - truth.depth[i]) < 0.01F * truth.depth[i] ? 1 : 0;
  }
  a.labels = equal / static_cast<double>(truth.label.size());
  a.depths = near / compared, a.colours = alike / equal;
  return a;
}

class GlCamera : public testing::Test {
 protected:
  GlCamera() : context_(makeHiddenContext()) {}

  Picture draw(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::vector<std::uint32_t> hidden = {},
               bool marks_lines = false) {
    GlCameraRenderer renderer(scene.ground);
    const GlLens lens(rays);
    GlAtlas atlas({{rays.camera().width, rays.camera().height}});
    atlas.clear(scene.sky);
    renderer.draw(lens, scene, X_WC, hidden, atlas, 0, marks_lines);
    atlas.beginReading();
    Picture picture;
    Picture* const pictures[] = {&picture};
    atlas.finishReading(pictures);
    return picture;
  }
  static Picture cast(const RayTable& rays, const RayScene& scene, const Pose& X_WC,
                      std::vector<std::uint32_t> hidden = {}) {
    PreparedScene work;
    Picture picture;
    castPicture(rays, scene, X_WC, hidden, {}, work, picture);
    return picture;
  }
  Agreement agreement(const CameraModel& camera, const RayScene& scene, const Pose& X_WC, const std::string& name) {
    const RayTable rays(camera);
    const Picture truth = cast(rays, scene, X_WC), seen = draw(rays, scene, X_WC);
    if (std::getenv("MUROSIMF_PICTURES") != nullptr) {
      writePng(std::string(std::getenv("MUROSIMF_PICTURES")) + "/" + name + "_cast.png", truth);
      writePng(std::string(std::getenv("MUROSIMF_PICTURES")) + "/" + name + "_gl.png", seen);
    }
    const Agreement a = compare(truth, seen);
    RecordProperty(name, std::to_string(a.labels) + " " + std::to_string(a.depths) + " " + std::to_string(a.colours));
    return a;
  }

  std::unique_ptr<GlContext> context_;
};

/// The 3 versus 3 game.
RayScene gameScene() {
  DrawnGame game;
  RayScene scene = game.simulation->view().initialScene();
  game.simulation->view().snapshot(game.simulation->frame() - 1, scene);
  return scene;
}

constexpr double kSharePixels = 0.99, kShareDepths = 0.998;

TEST_F(GlCamera, agreesWithTheRayCasterForTwentyLenses) {
  const RayScene scene = gameScene();
  const Pose X_WC = cameraPose({-1.4, -0.9, 0.5}, 0.5, 0.25);
  for (const auto& [name, camera] : lenses::all()) {
    SCOPED_TRACE(name);
    const Agreement a = agreement(camera, scene, X_WC, name);
    EXPECT_GT(a.things, 3000U);
    EXPECT_GT(a.labels, 0.9995);
    EXPECT_GT(a.depths, kShareDepths);
    EXPECT_GT(a.colours, 0.999);  // of all pixels to the corners: no border is black
  }
}

/// A wall that passes the camera and goes on behind it, a bar just before it, a capsule, and a mesh.
RayScene nearThings() {
  RayScene scene = camera_scene::makeGame();
  const auto add = [&](const Shape& shape, const Pose& X_WS, int label) {
    scene.drawables.push_back(camera_scene::place(shape, X_WS, {0.8F, 0.3F, 0.2F}, label));
  };
  add(makeBox({1.5, 0.02, 1}), {rotationZ(0.1), {-1.2, 0.28, 0.5}}, 40);
  add(makeCylinder(0.03, 4), {rotationX(0.5 * kPi), {-1.2, 0, 0.62}}, 41);
  add(makeCapsule(0.05, 0.3), {rotationY(0.7), {-1.0, -0.3, 0.3}}, 42);
  scene.drawables.push_back(camera_scene::place({}, {rotationZ(0.3), {-0.8, -0.1, 0.1}}, {0.2F, 0.3F, 0.9F}, 43));
  scene.drawables.back().mesh = mesh_shapes::boxOf({0.2, 0.2, 0.2}, 1).mesh();
  return scene;
}

TEST_F(GlCamera, clipsWhatReachesBehindTheCamera) {
  const Pose X_WC = cameraPose({-1.5, 0, 0.5}, 0.1, 0.2);
  const RayScene scene = nearThings();
  for (const auto& [name, camera] : lenses::invented()) {
    SCOPED_TRACE(name);
    const Agreement a = agreement(camera, scene, X_WC, "near " + name);
    EXPECT_GT(a.things, 20000U);
    EXPECT_GT(a.labels, kSharePixels);
    EXPECT_GT(a.depths, kShareDepths);  // 80 deg from the axis too, where inverse depth is not even over a triangle
    EXPECT_GT(a.colours, kSharePixels);
  }
}

TEST_F(GlCamera, hidesOwnersAndMarksLinesAsTheRayCasterDoes) {
  const RayTable rays(camera_scene::headCamera());
  const RayScene scene = camera_scene::makeGame();
  const Pose X_WC = cameraPose({-0.28, -0.15, 0.5}, 0.35, 0.35);
  const std::vector<std::uint32_t> hidden{150, 151};
  EXPECT_GT(compare(cast(rays, scene, X_WC, hidden), draw(rays, scene, X_WC, hidden)).labels, 0.998);
  EXPECT_LT(compare(cast(rays, scene, X_WC), draw(rays, scene, X_WC, hidden)).labels, kSharePixels);
  PreparedScene work;
  Picture truth;
  truth.marks_lines = true;
  castPicture(rays, scene, X_WC, {}, {}, work, truth);
  EXPECT_GT(compare(truth, draw(rays, scene, X_WC, {}, true)).labels, 0.998);
}

TEST_F(GlCamera, drawsInAnAtlasWhatItDrawsOneByOneWhileTheNextAreDrawn) {
  const RayScene scene = camera_scene::makeGame();
  const RayTable large(camera_scene::headCamera()), small(camera_scene::headCamera(160, 120));
  const GlLens large_lens(large), small_lens(small);
  GlCameraRenderer renderer(scene.ground);
  GlAtlas atlas({{640, 480}, {160, 120}, {640, 480}});
  const auto poseOf = [](int moment, int camera) {
    return cameraPose({-0.28, -0.15, 0.5}, 0.3 * camera - 0.5 * moment, 0.35);
  };
  std::array<Picture, 3> seen;
  const std::array<Picture*, 3> pictures{&seen[0], &seen[1], &seen[2]};
  const auto check = [&](int moment) {
    atlas.finishReading(pictures);
    for (int i = 0; i < 3; ++i) {
      const Picture alone = draw(i == 1 ? small : large, scene, poseOf(moment, i));
      const Agreement a = compare(alone, seen[static_cast<std::size_t>(i)]);  // but for rounding, by another place
      EXPECT_GT(a.labels, 0.9999) << moment << " " << i;
      EXPECT_GT(a.depths, 0.9999) << moment << " " << i;
      EXPECT_GT(a.colours, 0.9999) << moment << " " << i;
    }
  };
  for (int moment = 0; moment < 4; ++moment) {
    atlas.clear(scene.sky);
    for (int i = 0; i < 3; ++i)
      renderer.draw(i == 1 ? small_lens : large_lens, scene, poseOf(moment, i), {}, atlas, static_cast<std::size_t>(i));
    atlas.beginReading();
    if (moment > 0) check(moment - 1);
  }
  check(3);
  EXPECT_THROW(atlas.finishReading(pictures), std::logic_error);
  atlas.beginReading(), atlas.beginReading();
  EXPECT_THROW(atlas.beginReading(), std::logic_error);
}

TEST_F(GlCamera, refusesWhatItCannotDraw) {
  PaintedGround ground;
  ground.texture = std::make_shared<const GroundTexture>(1, 1, std::vector<std::uint8_t>{1, 2, 3});
  EXPECT_THROW(GlCameraRenderer{ground}, std::invalid_argument);
  EXPECT_THROW(GlAtlas({}), std::invalid_argument);
  EXPECT_THROW(GlAtlas({{640, 1'000'000}}), std::invalid_argument);
}

/// No edge of a refined mesh is long, it has no crack, and its area is that of before.
TEST(MeshRefinement, keepsTheSurfaceAndItsArea) {
  const Mesh coarse = stretched(makeBoxMesh(), {0.1, 0.5, 0.02}), fine = refined(coarse, 0.07);
  const auto at = [&](const Mesh& mesh, std::size_t i) {
    const auto& p = mesh.vertices[mesh.indices[i]].position;
    return Vector3{p[0], p[1], p[2]};
  };
  const auto areaOf = [&](const Mesh& mesh) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      area += 0.5 * norm(cross(at(mesh, i + 1) - at(mesh, i), at(mesh, i + 2) - at(mesh, i)));
    return area;
  };
  std::map<std::array<std::array<float, 3>, 2>, int> runs;
  for (std::size_t i = 0; i < fine.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    EXPECT_LE(norm(at(fine, next) - at(fine, i)), 0.07 + 1e-6);
    const auto &a = fine.vertices[fine.indices[i]].position, &b = fine.vertices[fine.indices[next]].position;
    ++runs[{a, b}], --runs[{b, a}];
  }
  for (const auto& [edge, excess] : runs) EXPECT_EQ(excess, 0);
  EXPECT_GT(fine.indices.size(), 4 * coarse.indices.size());
  EXPECT_NEAR(areaOf(fine), areaOf(coarse), 1e-6);
}

}  // namespace
}  // namespace murosimf
