#include "murosimf/modules/camera/robot_camera.h"

#include <cmath>
#include <utility>

#include "murosimf/algorithms/light/light_filters.h"

namespace murosimf {

RobotCamera::RobotCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera,
                         std::shared_ptr<const RayTable> rays, const RobotCameraSettings& settings, std::uint64_t seed,
                         double frame_length)
    : MountedCamera(world, view, robot, camera, settings.period, settings.phase, frame_length),
      rays_(std::move(rays)),
      settings_(settings),
      seed_(seed),
      gathers_light_(!settings.chain.empty() || !settings.isInstant()),
      queue_(std::lround(settings.latency / frame_length),
             static_cast<std::size_t>(std::ceil(settings.latency / settings.period)) + 1) {
  picture_.has_depth = settings_.depth;
  for (const PictureStep& step : settings_.chain) chain_.push_back(step.kind->make(model(), step.values));
}

void RobotCamera::render(const RayScene& scene, const MovingCamera& place, long frame) {
  const std::uint64_t key = noiseKey(seed_, path(), static_cast<std::uint64_t>(frame + 1));
  cast(scene, place, key);
  if (gathers_light_) finishLight(key, frame);
  last_frame_ = frame;
  waits_ = true;
  if (!late()) return;
  queue_.add(picture_, frame);
  picture_.has_depth = settings_.depth;
}

bool RobotCamera::deliver(long frame) {
  const long taken = late() ? queue_.next(frame, shown_) : std::exchange(waits_, false) ? last_frame_ : -1;
  if (taken < 0) return false;
  time_ = timeOf(taken) - settings_.shutter.age();
  if (settings_.format != PixelFormat::kRgb)
    storePixels(picture().rgb, picture().width, picture().height, settings_.format, bytes_);
  return true;
}

std::span<const std::uint8_t> RobotCamera::bytes() const {
  return settings_.format == PixelFormat::kRgb ? picture().rgb : bytes_;
}

void RobotCamera::cast(const RayScene& scene, const MovingCamera& place, std::uint64_t key) {
  CastOptions options;
  options.antialias = settings_.antialias;
  options.shadows = settings_.shadows;
  if (gathers_light_) {
    castThroughShutter(*rays_, scene, place, hidden(), options, settings_.shutter, work_, picture_, light_);
    return;
  }
  options.sensor = {static_cast<float>(settings_.gain), static_cast<float>(settings_.noise), key};
  castPicture(*rays_, scene, place.X_WC, hidden(), options, work_.prepared, picture_);
}

/// The chain; without one what a sensor does by itself.
void RobotCamera::finishLight(std::uint64_t key, long frame) {
  const double since_last = last_frame_ < 0 ? 0 : static_cast<double>(frame - last_frame_) * frameLength();
  for (const auto& module : chain_) module->apply(light_, {key, since_last});
  if (chain_.empty()) {
    const auto gain = static_cast<float>(settings_.gain);
    scaleLight(light_, {gain, gain, gain});
    addLightNoise(light_, {static_cast<float>(settings_.noise), 0, key});
  }
  storePixels(light_, PixelFormat::kRgb, picture_.rgb);
}

void RobotCamera::archive(StateArchive& archive) {
  archive(last_frame_, queue_);
  for (const auto& module : chain_) module->archive(archive);
}

}  // namespace murosimf
