#include "murosimf/modules/camera/robot_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

RobotCamera::RobotCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera,
                         std::shared_ptr<const RayTable> rays, const RobotCameraSettings& settings, std::uint64_t seed,
                         double frame_length)
    : robot_(robot),
      object_(camera),
      path_(world.path(camera)),
      rays_(std::move(rays)),
      settings_(settings),
      seed_(seed),
      period_(settings.period / frame_length),
      phase_(settings.phase / frame_length) {
  const MountPlace* place = world.findShared(camera, kCameraPlace);
  if (place == nullptr) throw std::invalid_argument(fmt::format("camera {} has no camera_place", path_));
  if (!(period_ >= 1)) throw std::invalid_argument(fmt::format("camera {} has no period of at least one frame", path_));
  picture_.has_depth = settings_.depth;
  row_ = place->row;
  X_BC_ = place->X_RM;
  if (const std::vector<int>* rows = world.findShared(camera, kHiddenRows)) {
    for (const int row : *rows) hidden_.push_back(view.ownerOf(robot, row));
  }
}

bool RobotCamera::isDue(long frame) const {
  const long near = std::lround((static_cast<double>(frame + 1) - phase_) / period_);
  for (long k = std::max(0L, near - 1); k <= near + 1; ++k) {
    if (std::lround(phase_ + static_cast<double>(k) * period_) == frame + 1) return true;
  }
  return false;
}

Pose RobotCamera::pose(const SceneView& view, long frame) const { return view.bodyPose(robot_, row_, frame) * X_BC_; }

void RobotCamera::render(const RayScene& scene, const Pose& X_WC, long frame) {
  CastOptions options;
  options.antialias = settings_.antialias;
  options.sensor.gain = static_cast<float>(settings_.gain);
  options.sensor.deviation = static_cast<float>(settings_.noise);
  options.sensor.key = noiseKey(seed_, path_, static_cast<std::uint64_t>(frame + 1));
  castPicture(*rays_, scene, X_WC, hidden_, options, work_, picture_);
}

}  // namespace murosimf
