#include "camera_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace murosimf::bench {
namespace {

constexpr double kEyeHeight = 0.52;
constexpr int kLeastPixels = 30;  // of what counts as seen

/// On a circle about the ball, two and two nearer and farther, so that each has others in view.
PlanarPose placeOf(int robot) {
  const double angle = 0.3 + 2 * kPi * robot / 6, radius = robot % 2 == 0 ? 0.9 : 1.3;
  return {radius * std::cos(angle), radius * std::sin(angle), angle + kPi};
}
PlanarPose placeBehind(int robot) {
  const double angle = 0.5 + 2.39996 * robot, radius = 1.5 + 0.06 * robot;
  return {1.2 * radius * std::cos(angle), 0.75 * radius * std::sin(angle), angle};
}

void requireSight(const CameraViews& views, std::size_t camera, const Picture& picture) {
  std::set<std::uint16_t> robots;
  long ball = 0;
  for (const std::uint16_t label : picture.label) {
    ball += label == camera_scene::kBallLabel;
    if (label >= camera_scene::kFirstRobotLabel && label != kSkyLabel) robots.insert(label);
  }
  if (ball >= kLeastPixels && robots.size() >= 2) return;
  throw std::runtime_error(fmt::format("camera {} of {} sees {} pixels of the ball and {} robots", camera,
                                       views.X_WC.size(), ball, robots.size()));
}

}  // namespace

CameraModel lensOfViews() { return camera_scene::headCamera(); }

CameraModel straightCameraOfViews() {
  const CameraModel lens = lensOfViews();
  const double left = -unproject(lens, {-0.5, lens.cy}).x, right = unproject(lens, {lens.width - 0.5, lens.cy}).x;
  return makePinholeCamera(lens.width, lens.height, std::atan2(left, 1.0) + std::atan2(right, 1.0));
}

CameraViews makeCameraViews(int robots) {
  CameraViews views;
  const RayScene game = camera_scene::makeGame();
  views.scene = game;
  views.scene.drawables.clear();
  for (const Drawable& d : game.drawables)
    if (d.label < camera_scene::kFirstRobotLabel) views.scene.drawables.push_back(d);
  for (int k = 0; k < robots; ++k) {
    const int label = camera_scene::kFirstRobotLabel + k;
    const PlanarPose at = k < 6 ? placeOf(k) : placeBehind(k);
    camera_scene::addRobot(at, k % 2 == 0 ? Colour{0.15F, 0.6F, 0.8F} : Colour{0.75F, 0.15F, 0.6F}, label, views.scene);
    if (k >= 6) continue;
    const double distance = std::hypot(at.x, at.y), pitch = 0.75 * std::atan2(kEyeHeight, distance);
    views.X_WC.push_back(camera_scene::cameraPose({at.x, at.y, kEyeHeight}, at.heading, pitch));
    views.hidden.push_back({static_cast<std::uint32_t>(10 * label), static_cast<std::uint32_t>(10 * label + 1)});
  }
  const RayTable rays(lensOfViews());
  PreparedScene work;
  Picture picture;
  for (std::size_t i = 0; i < views.X_WC.size(); ++i) {
    castPicture(rays, views.scene, views.X_WC[i], views.hidden[i], {}, work, picture);
    requireSight(views, i, picture);
  }
  return views;
}

CameraFrames::CameraFrames(const CameraModel& camera, int robots, CastLanes lanes)
    : views_(makeCameraViews(robots)), rays_(camera) {
  options_.lanes = lanes;
}

void CameraFrames::frame() {
  castPicture(rays_, views_.scene, views_.X_WC[next_], views_.hidden[next_], options_, work_, picture_);
  next_ = (next_ + 1) % views_.X_WC.size();
}

}  // namespace murosimf::bench
