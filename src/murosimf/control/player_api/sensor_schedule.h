#pragma once

/// @file Which sensors a client has turned on, how often each is told, and how much rendering that may cost.
///
/// A sensor that is turned on at time s with period p is told at s + p, s + 2p, ... All are off at first. Asking for
/// the period that a sensor has changes nothing. Times in ms of the simulation.

#include <string>
#include <vector>

#include "murosimf/control/player_api/device_book.h"
#include "murosimf/math/state_archive.h"

namespace murosimf::player_api {

/// Pixels of a camera.
struct PictureSize {
  int width = 0, height = 0;
};

class SensorSchedule {
 public:
  /// @param port_period  time between two messages [ms]
  /// @param rendering_quota  of all cameras together [MiB/s of simulated time]
  SensorSchedule(const DeviceBook& devices, std::vector<PictureSize> cameras, int port_period, double rendering_quota);

  /// @returns empty where it was obeyed; else why it was not, for the client
  std::string ask(const std::string& name, long time_step, long now);
  void turnAllOff();
  /// Whether this device's value belongs into the message of this time. Cameras: whether it is on.
  bool isDue(int device, long now) const;
  /// Time between two values of a device [ms]; 0: it is off.
  long period(int device) const { return watched_[static_cast<std::size_t>(device)].period; }
  /// Whether some camera's period has changed since the last call.
  bool camerasChanged();

  /// MiB a second of simulated time that pictures of this size make.
  static double renderingBandwidth(const PictureSize& size, long time_step);
  void archive(StateArchive& archive);

 private:
  struct Watched {
    long period = 0, start = 0;
    void archive(StateArchive& archive) { archive(period, start); }
  };
  std::string refusal(int device, const std::string& name, long time_step) const;
  std::string overQuota(int device, long time_step) const;

  const DeviceBook& devices_;
  std::vector<PictureSize> cameras_;
  long port_period_;
  double rendering_quota_;
  std::vector<Watched> watched_;  // as devices
  bool cameras_changed_ = false;
};

}  // namespace murosimf::player_api
