#pragma once

/// @file What all levels of detail of a robot's camera have in common, and its range sensors with them: where it sits,
/// and when it looks.

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/algorithms/light/shutter.h"
#include "murosimf/math/state_archive.h"
#include "murosimf/modules/camera/scene_view.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class MountedCamera {
 public:
  /// World and view are looked at here alone. Period and phase in s.
  /// @throws std::invalid_argument when the object lacks a mount, or when the period is below one frame.
  MountedCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera, double period, double phase,
                double frame_length, const Constant<MountPlace>& mount = kCameraPlace);
  MountedCamera(const MountedCamera&) = delete;
  MountedCamera& operator=(const MountedCamera&) = delete;
  virtual ~MountedCamera() = default;

  ObjectId object() const { return object_; }
  const std::string& path() const { return path_; }
  /// Time between pictures [frames], not always a whole number; 0: it takes none.
  double period() const { return period_; }
  /// From the beginning of this frame on a picture every `period` seconds, the first one so much later; 0: none. The
  /// period that it has changes nothing, and the one that it was made with brings its phase back. At least one frame.
  void lookEvery(double period, long frame);
  /// True when a picture is due at the end of this frame; `frame` = -1 is the moment before the first one. Picture k is
  /// taken at phase + k period, rounded to frames: at 30 Hz and 1 ms after 33, 67, 100 frames, so nothing drifts.
  bool isDue(long frame) const;
  /// Where it is at the end of a frame, and how it moves where needsMotion().
  MovingCamera place(const SceneView& view, long frame) const;

  /// Whether a look needs the motion of camera and things.
  virtual bool needsMotion() const = 0;
  /// A look at a snapshot goes through three steps. The scene, which must stay as it is until the last one is done,
  /// needs motions where needsMotion().
  /// Frame thread: takes the order.
  virtual void order(const RayScene& scene, const MovingCamera& place, long frame) = 0;
  /// Frame thread, when all cameras of the moment have their orders.
  virtual void start() {}
  /// Any thread, while the simulation goes on: does the work that was ordered.
  virtual void look() = 0;
  /// All three, of a camera that is alone.
  void render(const RayScene& scene, const MovingCamera& place, long frame) {
    order(scene, place, frame);
    start();
    look();
  }
  /// Lets arrive what has spent its time on the way by the end of this frame. @return false where nothing does
  virtual bool deliver(long frame) = 0;
  virtual void archive(StateArchive& archive) = 0;
  void archiveSchedule(StateArchive& archive) { archive(period_, phase_); }

 protected:
  double frameLength() const { return frame_length_; }
  /// Owners of drawables that it does not show.
  const std::vector<std::uint32_t>& hidden() const { return hidden_; }
  /// Seconds from the start to the end of a frame.
  double timeOf(long frame) const { return static_cast<double>(frame + 1) * frame_length_; }

 private:
  ObjectId robot_, object_;
  std::string path_;
  double period_, phase_, frame_length_;     // period and phase in frames
  const double first_period_, first_phase_;  // that it was made with
  int row_ = 0;
  Pose X_BC_;
  std::vector<std::uint32_t> hidden_;
};

}  // namespace murosimf
