#include "murosimf/control/player_api/sensor_schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace murosimf::player_api {

namespace {

constexpr long kCameraSteps = 2;  // port periods between two pictures, at least [player.cpp: camera_min_time_step]
constexpr double kMebibyte = 1048576;

}  // namespace

SensorSchedule::SensorSchedule(const DeviceBook& devices, std::vector<PictureSize> cameras, int port_period,
                               double rendering_quota)
    : devices_(devices),
      cameras_(std::move(cameras)),
      port_period_(port_period),
      rendering_quota_(rendering_quota),
      watched_(static_cast<std::size_t>(devices.count())) {}

double SensorSchedule::renderingBandwidth(const PictureSize& size, long time_step) {
  return static_cast<double>(size.width) * size.height * 3 * 1000 / static_cast<double>(time_step) / kMebibyte;
}

std::string SensorSchedule::overQuota(int device, long time_step) const {
  double wanted = 0;
  for (int i = 0; i < devices_.count(); ++i) {
    const long step = i == device ? time_step : period(i);
    if (!devices_.isCamera(i) || step == 0) continue;
    wanted += renderingBandwidth(cameras_[static_cast<std::size_t>(devices_.device(i).part)], step);
  }
  if (wanted <= rendering_quota_) return "";
  return fmt::format("pictures would take {:.0f} MB/s of rendering, allowed are {:.0f} MB/s", wanted, rendering_quota_);
}

std::string SensorSchedule::refusal(int device, const std::string& name, long time_step) const {
  const auto ignored = [&](const std::string& why) {
    return fmt::format("time step of {} ms for \"{}\" ignored: {}", time_step, name, why);
  };
  if (device < 0) return ignored("the robot has no device of this name");
  if (devices_.device(device).kind == client::DeviceKind::kMotor) return ignored("a motor is no sensor");
  if (time_step == 0) return "";
  const long least = devices_.isCamera(device) ? kCameraSteps * port_period_ : port_period_;
  if (time_step < least) return ignored(fmt::format("expected at least {} ms", least));
  if (time_step % port_period_ != 0) return ignored(fmt::format("expected a multiple of {} ms", port_period_));
  const std::string over = devices_.isCamera(device) ? overQuota(device, time_step) : "";
  return over.empty() ? "" : ignored(over);
}

std::string SensorSchedule::ask(const std::string& name, long time_step, long now) {
  const int device = devices_.find(name);
  std::string why = refusal(device, name, time_step);
  if (!why.empty()) return why;
  Watched& watched = watched_[static_cast<std::size_t>(device)];
  if (watched.period == time_step) return "";
  watched = {time_step, now};
  cameras_changed_ = cameras_changed_ || devices_.isCamera(device);
  return "";
}

void SensorSchedule::turnAllOff() {
  for (int i = 0; i < devices_.count(); ++i) {
    cameras_changed_ = cameras_changed_ || (devices_.isCamera(i) && period(i) > 0);
    watched_[static_cast<std::size_t>(i)] = {};
  }
}

bool SensorSchedule::isDue(int device, long now) const {
  const Watched& watched = watched_[static_cast<std::size_t>(device)];
  if (watched.period == 0) return false;
  // When a picture comes is the camera's affair.
  return devices_.isCamera(device) || (now > watched.start && (now - watched.start) % watched.period == 0);
}

bool SensorSchedule::camerasChanged() { return std::exchange(cameras_changed_, false); }

void SensorSchedule::archive(StateArchive& archive) { archive(watched_, cameras_changed_); }

}  // namespace murosimf::player_api
