#include "murosimf/modules/camera/robot_camera.h"

#include <cmath>
#include <utility>

#include "murosimf/algorithms/light/light_filters.h"

namespace murosimf {

namespace {

bool needsLight(const RobotCameraSettings& settings) {
  const bool sensor = settings.gain != 1 || settings.noise > 0;
  return !settings.chain.empty() || !settings.isInstant() || (sensor && !settings.maker->can.sensor);
}

}  // namespace

RobotCamera::RobotCamera(const World& world, const SceneView& view, ObjectId robot, ObjectId camera,
                         std::shared_ptr<const RayTable> rays, const RobotCameraSettings& settings, std::uint64_t seed,
                         double frame_length)
    : MountedCamera(world, view, robot, camera, settings.period, settings.phase, frame_length),
      rays_(std::move(rays)),
      settings_(settings),
      seed_(seed),
      gathers_light_(needsLight(settings)),
      latency_(std::lround(settings.latency / frame_length)),
      queue_(latency_, mostOnTheWay()) {
  taken_.reserve(mostOnTheWay() + 1);
  for (const PictureStep& step : settings_.chain) chain_.push_back(step.kind->make(model(), step.values));
  maker_ = settings_.maker->make(wish(), view.initialScene().ground);
}

std::size_t RobotCamera::mostOnTheWay() const {
  return static_cast<std::size_t>(std::ceil(settings_.latency / settings_.period)) + 1;
}

PictureWish RobotCamera::wish() const {
  PictureWish wish;
  wish.rays = rays_;
  wish.hidden = hidden();
  wish.antialias = settings_.antialias, wish.shadows = settings_.shadows, wish.depth = settings_.depth;
  wish.shutter = settings_.shutter;
  wish.sensor = {static_cast<float>(settings_.gain), static_cast<float>(settings_.noise), 0};
  wish.light = gathers_light_;
  wish.most = mostOnTheWay() + 1;
  return wish;
}

void RobotCamera::order(const RayScene& scene, const MovingCamera& place, long frame) {
  const std::uint64_t key = noiseKey(seed_, path(), static_cast<std::uint64_t>(frame + 1));
  const double since_last = last_frame_ < 0 ? 0 : static_cast<double>(frame - last_frame_) * frameLength();
  maker_->order({&scene, place, key});
  taken_.push_back({frame, key, since_last});
  last_frame_ = frame;
}

/// A maker that works elsewhere is asked for a late picture only when it is due.
void RobotCamera::look() {
  maker_->settle();
  while (!taken_.empty() && (maker_->isPrompt() || !late() || taken_.size() > mostOnTheWay())) develop();
}

/// Oldest picture first, as state of the chain goes on from one to the next.
void RobotCamera::develop() {
  const Taken taken = taken_.front();
  taken_.erase(taken_.begin());
  maker_->fetch(picture_, light_);
  if (gathers_light_) finishLight(taken);
  waits_ = true;
  if (late()) queue_.add(picture_, taken.frame);
}

bool RobotCamera::deliver(long frame) {
  while (late() && !taken_.empty() && taken_.front().frame + latency_ <= frame) develop();
  const long taken = late() ? queue_.next(frame, shown_).value_or(-1) : std::exchange(waits_, false) ? last_frame_ : -1;
  if (taken < 0) return false;
  time_ = timeOf(taken) - settings_.shutter.age();
  if (settings_.format != PixelFormat::kRgb)
    storePixels(picture().rgb, picture().width, picture().height, settings_.format, bytes_);
  return true;
}

std::span<const std::uint8_t> RobotCamera::bytes() const {
  return settings_.format == PixelFormat::kRgb ? picture().rgb : bytes_;
}

/// The chain; without one what a sensor does by itself.
void RobotCamera::finishLight(const Taken& taken) {
  for (const auto& module : chain_) module->apply(light_, {taken.key, taken.since_last});
  if (chain_.empty()) {
    const auto gain = static_cast<float>(settings_.gain);
    scaleLight(light_, {gain, gain, gain});
    addLightNoise(light_, {static_cast<float>(settings_.noise), 0, taken.key});
  }
  storePixels(light_, PixelFormat::kRgb, picture_.rgb);
}

/// Pictures are kept as they are delivered: those that are still being made are waited for.
void RobotCamera::archive(StateArchive& archive) {
  while (!taken_.empty()) develop();
  archive(last_frame_);
  queue_.archive(archive, [&](Picture& picture, long& frame) {
    archive(picture.width, picture.height, picture.rgb, picture.depth, picture.label, frame);
  });
  for (const auto& module : chain_) module->archive(archive);
}

}  // namespace murosimf
