// Pictures through OpenGL, without a display.

#include <cmath>

#include "murosimf/algorithms/ray_caster.h"
#include "murosimf/render/gl/gl_context.h"
#include "murosimf/render/gl/gl_renderer.h"
#include "murosimf/render/orbit_camera.h"
#include "murosimf/simulation/png_writer.h"
#include "render/drawn_game.h"

namespace murosimf {
namespace {

using test::DrawnGame;

/// Place of a point's pixel in the picture's numbers.
std::size_t pixelOf(const Picture& picture, const GlView& view, const Vector3& p_W) {
  const ImagePoint place = *projectPoint(view.camera, applyInverse(view.X_WC, p_W));
  return picture.index(static_cast<int>(std::lround(place.u)), static_cast<int>(std::lround(place.v)));
}

bool isNear(std::uint8_t seen, float wanted) { return std::abs(seen - std::lround(255 * wanted)) < 2; }

class GlPicture : public testing::Test {
 protected:
  GlPicture() : context_(makeHiddenContext()) {}
  std::unique_ptr<GlContext> context_;
};

GlView viewOf(const OrbitCamera& camera, int width, int height) { return {camera.model(width, height), camera.pose()}; }

OrbitCamera acrossTheField() {
  OrbitCamera camera;
  camera.distance = 5, camera.azimuth = -1.2, camera.elevation = 0.25;
  return camera;
}

TEST_F(GlPicture, hasTheLabelsThatTheRayCasterSees) {
  DrawnGame game;
  const GlView view = viewOf(acrossTheField(), 640, 480);
  GlRenderer renderer;
  const GlLabelTarget target(640, 480);
  renderer.drawLabels(game.draw(), view, target, kSkyLabel);
  std::vector<std::uint32_t> labels;
  target.read(labels);

  const RayTable rays(view.camera);
  RayScene scene = game.simulation->view().initialScene();
  game.simulation->view().snapshot(game.simulation->frame() - 1, scene);
  PreparedScene work;
  Picture picture;
  castPicture(rays, scene, view.X_WC, {}, {}, work, picture);
  std::size_t equal = 0, objects = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::uint32_t seen = labels[i] == kSkyLabel ? kSkyLabel : labelOfPart(labels[i]);
    if (seen == picture.label[i]) ++equal;
    if (picture.label[i] != kGroundLabel && picture.label[i] != kSkyLabel) ++objects;
  }
  RecordProperty("differing_pixels", static_cast<int>(labels.size() - equal));
  EXPECT_GT(objects, 6000U);
  // Curved surfaces are polygons here: their silhouettes differ by a part of a pixel, some 1 in 100 of what is seen.
  EXPECT_LT(static_cast<double>(labels.size() - equal), 0.03 * static_cast<double>(objects));
  EXPECT_GT(static_cast<double>(equal), 0.999 * static_cast<double>(labels.size()));
}

TEST_F(GlPicture, showsTheColourOfAThingWhereTheCameraProjectsIt) {
  DrawnGame game;
  const GlView view = viewOf(acrossTheField(), 320, 240);
  GlRenderer renderer;
  const GlColourTarget target(320, 240);
  target.bind();
  GlLight light;
  light.ambient = 1;  // colours as they are
  renderer.drawColours(game.draw(), view, light);
  Picture picture;
  target.read(picture);
  const auto shows = [&](const Vector3& p_W, const Colour& c) {
    const std::uint8_t* rgb = picture.rgb.data() + 3 * pixelOf(picture, view, p_W);
    return isNear(rgb[0], c.red) && isNear(rgb[1], c.green) && isNear(rgb[2], c.blue);
  };
  const PaintedGround& ground = game.simulation->view().initialScene().ground;
  EXPECT_TRUE(shows({0, 0, 0.07}, *game.scene->ball.colour));
  EXPECT_TRUE(shows({0.6, -1.2, 0}, ground.carpet));
  EXPECT_TRUE(shows({0, 1.0, 0}, ground.paint));  // the halfway line
  EXPECT_TRUE(shows({0, 12, 0}, ground.surroundings));
  EXPECT_TRUE(shows({-38, 100, 7}, light.sky));
}

TEST_F(GlPicture, hasAShadowBehindTheBallAndNoneWithoutTheLamp) {
  DrawnGame game;
  OrbitCamera above;
  above.target_W = {}, above.distance = 1, above.elevation = 1.5;
  const GlView view = viewOf(above, 200, 200);
  GlRenderer renderer;
  const GlColourTarget target(200, 200);
  const auto brightnessAt = [&](const Vector3& p_W, bool shadows) {
    target.bind();
    GlLight light;
    light.shadows = shadows;
    light.light_W = {1, 0, 1};
    light.shadow_reach = 1;
    renderer.drawColours(game.draw(), view, light);
    Picture picture;
    target.read(picture);
    return picture.rgb[3 * pixelOf(picture, view, p_W) + 1];
  };
  const Vector3 behind_W{-0.13, 0, 0};  // light falls from +x and above
  EXPECT_LT(brightnessAt(behind_W, true) + 20, brightnessAt(behind_W, false));
  EXPECT_EQ(brightnessAt({0.3, 0.3, 0}, true), brightnessAt({0.3, 0.3, 0}, false));
}

TEST_F(GlPicture, tellsWhoDraws) {
  const GlIdentity identity = identifyGl();
  EXPECT_NE(identity.renderer, "");
  const bool warned = describe(identity).find("warning") != std::string::npos;
  EXPECT_EQ(warned, identity.software);
}

}  // namespace
}  // namespace murosimf
