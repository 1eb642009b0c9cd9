#pragma once

/// @file One camera of a robot: the picture that it takes of a snapshot of the world.

#include <memory>
#include <string>

#include "murosimf/algorithms/ray_caster.h"
#include "murosimf/modules/camera/scene_view.h"

namespace murosimf {

/// Level of detail "ray_caster": casts a ray through the real lens for every pixel, adds the sensor's noise.
/// Parameters of the method; the lens and the mount are constants of the camera's object.
struct RobotCameraSettings {
  double period = 0.05;  ///< between pictures [s]
  double phase = 0;      ///< time of the first picture [s]
  double noise = 0.015;  ///< standard deviation, share of full scale
  double gain = 1;       ///< brightness of the sensor
  /// Four samples a pixel where a silhouette passes, as a real sensor averages light over its pixels.
  bool antialias = false;
  bool depth = false;  ///< whether pictures have depths
};

class RobotCamera {
 public:
  /// World and view are looked at here alone.
  /// @throws std::invalid_argument when the object lacks a mount, or when the period is below one frame.
  RobotCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera,
              std::shared_ptr<const RayTable> rays, const RobotCameraSettings& settings, std::uint64_t seed,
              double frame_length);

  ObjectId object() const { return object_; }
  const CameraModel& model() const { return rays_->camera(); }
  const RobotCameraSettings& settings() const { return settings_; }
  /// Time between pictures [frames], not always a whole number.
  double period() const { return period_; }
  /// True when a picture is due at the end of this frame; `frame` = -1 is the moment before the first one. Picture k is
  /// taken at phase + k period, rounded to frames: at 30 Hz and 1 ms after 33, 67, 100 frames, so nothing drifts.
  bool isDue(long frame) const;
  /// X_WC at the end of a frame.
  Pose pose(const SceneView& view, long frame) const;
  /// Renders into picture(). May run on any thread while the simulation goes on; reads only its arguments.
  void render(const RayScene& scene, const Pose& X_WC, long frame);
  const Picture& picture() const { return picture_; }

 private:
  ObjectId robot_, object_;
  std::string path_;
  std::shared_ptr<const RayTable> rays_;
  RobotCameraSettings settings_;
  std::uint64_t seed_;
  double period_, phase_;  // in frames
  int row_;
  Pose X_BC_;
  std::vector<std::uint32_t> hidden_;
  PreparedScene work_;
  Picture picture_;
};

}  // namespace murosimf
