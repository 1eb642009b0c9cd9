#include "murosimf/modules/camera/mounted_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

MountedCamera::MountedCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera, double period,
                             double phase, double frame_length, const Constant<MountPlace>& mount)
    : robot_(robot),
      object_(camera),
      path_(world.path(camera)),
      period_(period / frame_length),
      phase_(phase / frame_length),
      frame_length_(frame_length),
      first_period_(period_),
      first_phase_(phase_) {
  const MountPlace* place = world.findShared(camera, mount);
  if (place == nullptr) throw std::invalid_argument(fmt::format("{} has no {}", path_, mount.name));
  if (!(period_ >= 1)) throw std::invalid_argument(fmt::format("{} has no period of at least one frame", path_));
  row_ = place->row;
  X_BC_ = place->X_RM;
  if (const std::vector<int>* rows = world.findShared(camera, kHiddenRows)) {
    for (const int row : *rows) hidden_.push_back(view.ownerOf(robot, row));
  }
}

void MountedCamera::lookEvery(double period, long frame) {
  // A period that was told in seconds is that of the scenario's where they are the same time.
  const double asked = period > 0 ? std::max(1.0, period / frame_length_) : 0;
  const auto same = [&](double other) { return std::abs(asked - other) < 1e-9 * std::max(asked, other); };
  if (asked == period_ || same(period_)) return;
  if (same(first_period_)) {
    period_ = first_period_, phase_ = first_phase_;
  } else {
    period_ = asked, phase_ = static_cast<double>(frame) + asked;
  }
}

bool MountedCamera::isDue(long frame) const {
  if (period_ <= 0) return false;
  const long near = std::lround((static_cast<double>(frame + 1) - phase_) / period_);
  for (long k = std::max(0L, near - 1); k <= near + 1; ++k) {
    if (std::lround(phase_ + static_cast<double>(k) * period_) == frame + 1) return true;
  }
  return false;
}

MovingCamera MountedCamera::place(const SceneView& view, long frame) const {
  const Pose X_WB = view.bodyPose(robot_, row_, frame), X_WC = X_WB * X_BC_;
  if (!needsMotion()) return {X_WC, {}};
  const SpatialMotion<double> V = view.bodyMotion(robot_, row_, frame);
  return {X_WC, {V.w, V.v + cross(V.w, X_WC.translation - X_WB.translation)}};
}

}  // namespace murosimf
