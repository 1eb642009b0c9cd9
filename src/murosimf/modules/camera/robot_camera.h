#pragma once

/// @file One camera of a robot: the picture that it takes of a snapshot of the world.

#include <memory>
#include <string>

#include "murosimf/algorithms/light/pixel_format.h"
#include "murosimf/math/arrival_queue.h"
#include "murosimf/modules/camera/mounted_camera.h"
#include "murosimf/modules/camera/picture_maker.h"
#include "murosimf/modules/camera/picture_modules.h"

namespace murosimf {

/// A picture module of a camera's chain, with the values of its parameters.
struct PictureStep {
  const PictureModuleKind* kind = nullptr;
  PictureValues values;
};

/// How a camera takes pictures; the lens and the mount are constants of the camera's object.
struct RobotCameraSettings {
  std::shared_ptr<const PictureMakerKind> maker = rayCasterKind();
  double period = 0.05;  ///< between pictures [s]
  double phase = 0;      ///< time of the first picture [s]
  double noise = 0.015;  ///< standard deviation, share of full scale; where there is no chain
  double gain = 1;       ///< brightness of the sensor; likewise
  /// Four samples a pixel where a silhouette passes, as a real sensor averages light over its pixels.
  bool antialias = false;
  bool shadows = false;            ///< hard shadows of the lamp on the ground and on things
  bool depth = false;              ///< whether pictures have depths
  Shutter shutter;                 ///< a moment, unless told
  std::vector<PictureStep> chain;  ///< what happens to the light, in this order; none: gain and noise
  PixelFormat format = PixelFormat::kRgb;
  double latency = 0;  ///< from the end of the exposure until the picture is delivered [s]

  /// Whether pictures need the motion of camera and things.
  bool isInstant() const { return shutter.readout <= 0 && shutter.exposure <= 0; }
};

class RobotCamera final : public MountedCamera {
 public:
  /// @throws std::invalid_argument as MountedCamera does, and what the maker throws that cannot work on this machine.
  RobotCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera,
              std::shared_ptr<const RayTable> rays, const RobotCameraSettings& settings, std::uint64_t seed,
              double frame_length);

  const CameraModel& model() const { return rays_->camera(); }
  const RobotCameraSettings& settings() const { return settings_; }
  bool needsMotion() const override { return !settings_.isInstant(); }
  const PictureMaker& maker() const { return *maker_; }
  void order(const RayScene& scene, const MovingCamera& place, long frame) override;
  void start() override { maker_->start(); }
  void look() override;
  /// Lets the oldest picture arrive that was rendered and has spent the latency on its way by the end of this frame.
  bool deliver(long frame) override;
  /// The picture that has arrived last; where there is no latency, the one that was rendered last.
  const Picture& picture() const { return late() ? shown_ : picture_; }
  /// Its bytes as control software gets them, and the middle of its exposure [s].
  std::span<const std::uint8_t> bytes() const;
  double time() const { return time_; }

  void archive(StateArchive& archive) override;

 private:
  struct Taken {  // a picture that its maker has
    long frame = 0;
    std::uint64_t key = 0;
    double since_last = 0;  // [s]
  };
  PictureWish wish() const;
  void develop();
  void finishLight(const Taken& taken);
  bool late() const { return settings_.latency > 0; }
  std::size_t mostOnTheWay() const;

  std::shared_ptr<const RayTable> rays_;
  RobotCameraSettings settings_;
  std::uint64_t seed_;
  std::vector<std::unique_ptr<PictureModule>> chain_;
  std::unique_ptr<PictureMaker> maker_;
  bool gathers_light_;
  long last_frame_ = -1;      // of the picture before; -1: none
  std::vector<Taken> taken_;  // oldest first
  LightPicture light_;
  Picture picture_, shown_;  // shown_: where there is latency
  long latency_;             // [frames]
  ArrivalQueue<Picture> queue_;
  bool waits_ = false;               // picture_ has not been delivered yet
  std::vector<std::uint8_t> bytes_;  // in a format that is not the picture's
  double time_ = 0;
};

}  // namespace murosimf
