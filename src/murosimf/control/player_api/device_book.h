#pragma once

/// @file The devices of a robot by the names that clients of the player API call them.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control/client/robot_description.h"

namespace murosimf::player_api {

class DeviceBook {
 public:
  explicit DeviceBook(std::vector<client::DeviceDescription> devices);

  int count() const { return static_cast<int>(devices_.size()); }
  const client::DeviceDescription& device(int index) const { return devices_[static_cast<std::size_t>(index)]; }
  /// The device with this name; -1: there is none.
  int find(std::string_view name) const;
  /// The motor with this name; -1: there is none.
  int findMotor(std::string_view name) const;
  int findCamera(std::string_view name) const;
  /// The motor of a joint; -1: it has none.
  int motorOf(int joint) const;
  bool isCamera(int index) const { return device(index).kind == client::DeviceKind::kCamera; }

 private:
  int findKind(std::string_view name, client::DeviceKind kind) const;
  std::vector<client::DeviceDescription> devices_;
  std::map<std::string, int, std::less<>> by_name_;
};

/// What a device says where the simulator has this value.
double deviceValue(const client::DeviceDescription& device, double value);
/// The value that a device means: its inverse, within its limits.
double simulatedValue(const client::DeviceDescription& device, double told);

}  // namespace murosimf::player_api
