#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/camera_scene.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;

/// White paint on black ground in full light: a byte is 255 times the share of the pixel that is painted.
struct Canvas {
  explicit Canvas(const CameraModel& model = makePinholeCamera(640, 480, 1.0)) : camera(model), rays(camera) {
    scene.ambient = 1.0F;
    scene.ground.carpet = scene.ground.surroundings = scene.sky = {0, 0, 0};
    scene.ground.paint = {1, 1, 1};
  }
  void shoot(const Pose& X_WC) { castPicture(rays, scene, X_WC, {}, {}, work, picture); }
  double share(int u, int v) const { return picture.rgb[3 * picture.index(u, v)] / 255.0; }
  double sum() const {
    double total = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) total += picture.rgb[i] / 255.0;
    return total;
  }

  CameraModel camera;
  RayTable rays;
  RayScene scene;
  PreparedScene work;
  Picture picture;
};

bool isPainted(const PaintedGround& ground, double x, double y) {
  for (const PaintedLine& line : ground.lines) {
    const double dx = line.b_x - line.a_x, dy = line.b_y - line.a_y, length = std::hypot(dx, dy);
    const double along = ((x - line.a_x) * dx + (y - line.a_y) * dy) / length;
    const double across = ((y - line.a_y) * dx - (x - line.a_x) * dy) / length;
    if (along >= 0 && along <= length && std::fabs(across) <= 0.5 * line.width) return true;
  }
  for (const PaintedCircle& c : ground.circles)
    if (std::fabs(std::hypot(x - c.x, y - c.y) - c.radius) <= 0.5 * c.width) return true;
  return false;
}

TEST(CameraPaint, LinesOfAnyWidthAndDirectionKeepTheirArea) {
  Canvas canvas;
  const double height = 3.0, pixel = height / canvas.camera.fx;  // 5.1 mm
  for (const double width : {0.001, 0.003, 0.05, 0.4})
    for (const double angle : {0.0, 0.3, 0.7853981, 1.5707963}) {
      const double x = 0.8 * std::cos(angle), y = 0.8 * std::sin(angle);
      canvas.scene.ground.lines = {{-x, -y, x + 0.001, y + 0.002, width}};
      canvas.shoot(lookAt({0.003, 0.0021, height}, {0.003, 0.0021, 0}));
      const double area = std::hypot(2 * x + 0.001, 2 * y + 0.002) * width / (pixel * pixel);
      EXPECT_NEAR(canvas.sum(), area, 0.035 * area + 2.0) << width << " " << angle;
    }
}

TEST(CameraPaint, RingsKeepTheirArea) {
  Canvas canvas;
  const double height = 3.0, pixel = height / canvas.camera.fx;
  for (const double width : {0.003, 0.05, 0.3}) {
    canvas.scene.ground.circles = {{0.1, -0.05, 0.7, width}};
    canvas.shoot(lookAt({0, 0, height}, {0, 0, 0}));
    const double area = 2 * kPi * 0.7 * width / (pixel * pixel);
    EXPECT_NEAR(canvas.sum(), area, 0.01 * area) << width;
  }
}

TEST(CameraPaint, ObliqueViewAgreesWithManySamplesAPixel) {
  Canvas canvas(camera_scene::headCamera());
  camera_scene::paintField(4.5, 3.0, 0.6, canvas.scene.ground);
  const Pose X_WC = cameraPose({-1.3, -0.4, 0.45}, 0.3, 0.35);
  canvas.shoot(X_WC);
  double squares = 0, worst = 0;
  int compared = 0;
  for (int v = 100; v < 480; v += 5)
    for (int u = 1; u < 640; u += 7) {
      constexpr int kSamples = 10;
      int painted = 0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const int column = k % kSamples, row = k / kSamples;
        const double du = (column + 0.5) / kSamples - 0.5, dv = (row + 0.5) / kSamples - 0.5;
        const RaySlopes r = unproject(canvas.camera, {u + du, v + dv});
        const Vector3 d = X_WC.rotation * Vector3{r.x, r.y, 1}, p = X_WC.translation + d * (-X_WC.translation.z / d.z);
        painted += d.z < 0 && isPainted(canvas.scene.ground, p.x, p.y);
      }
      const double error = canvas.share(u, v) - double(painted) / (kSamples * kSamples);
      if (painted == 0 && error == 0) continue;
      ++compared;
      squares += error * error, worst = std::max(worst, std::fabs(error));
    }
  EXPECT_GT(compared, 150);
  EXPECT_LT(std::sqrt(squares / compared), 0.05);
  EXPECT_LT(worst, 0.4);  // where two lines meet
}

TEST(CameraPaint, DistantLineDoesNotFlickerWhenTheCameraMoves) {
  Canvas canvas;
  canvas.scene.ground.lines = {{6, -1, 6, 1, 0.05}};  // 0.2 pixels high
  double least = 1e9, most = 0;
  for (int k = 0; k < 40; ++k) {
    canvas.shoot(cameraPose({0, 0, 0.4}, 0, 0.002 * k));
    least = std::min(least, canvas.sum()), most = std::max(most, canvas.sum());
  }
  EXPECT_GT(least, 5.0);
  EXPECT_LT(most / least, 1.06);
}

TEST(CameraPaint, CarpetEndsWhereItEnds) {
  Canvas canvas;
  canvas.scene.ground.carpet = {1, 1, 1};
  canvas.scene.ground.half_length = 0.7, canvas.scene.ground.half_width = 0.4;
  const double height = 3.0, pixel = height / canvas.camera.fx;
  canvas.shoot(lookAt({0, 0, height}, {0, 0, 0}));
  EXPECT_NEAR(canvas.sum(), 1.4 * 0.8 / (pixel * pixel), 0.003 * 1.4 * 0.8 / (pixel * pixel));
}

TEST(CameraPaint, ManyLinesAreAllDrawn) {
  Canvas canvas;
  for (int k = 0; k < 50; ++k) canvas.scene.ground.lines.push_back({-0.5, -1.0 + 0.04 * k, 0.5, -1.0 + 0.04 * k, 0.01});
  const double height = 4.0, pixel = height / canvas.camera.fx;
  canvas.shoot(lookAt({0, 0, height}, {0, 0, 0}));
  EXPECT_NEAR(canvas.sum(), 50 * 0.01 / (pixel * pixel), 0.02 * 50 * 0.01 / (pixel * pixel));
}

TEST(CameraPaint, NothingIsPaintedOnThingsOrTheSky) {
  Canvas canvas;
  canvas.scene.ground.lines = {{-3, 0, 3, 0, 1.0}};
  canvas.scene.drawables.push_back(camera_scene::place(makeBox({0.3, 0.3, 0.3}), {{}, {1, 0, 0.15}}, {0, 0, 0}, 9));
  canvas.scene.drawables.push_back(camera_scene::place(makeSphere(0.1), {{}, {1, 0.3, 0.1}}, {0, 0, 1}, kGroundLabel));
  canvas.shoot(cameraPose({0, 0, 0.4}, 0, 0.2));
  int box = 0, painted = 0, blue = 0;
  for (std::size_t i = 0; i < canvas.picture.label.size(); ++i) {
    EXPECT_TRUE(canvas.picture.label[i] == kGroundLabel || canvas.picture.rgb[3 * i] == 0);
    box += canvas.picture.label[i] == 9, painted += canvas.picture.rgb[3 * i] == 255;
  }
  for (std::size_t i = 0; i < canvas.picture.rgb.size(); i += 3)
    blue += canvas.picture.rgb[i] == 0 && canvas.picture.rgb[i + 2] == 255 && canvas.picture.label[i / 3] == 0;
  EXPECT_GT(box, 1000);
  EXPECT_GT(blue, 1000);  // a thing that has the ground's label is no ground
  EXPECT_GT(painted, 10000);
}

}  // namespace
}  // namespace murosimf
