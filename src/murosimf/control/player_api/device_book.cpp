#include "murosimf/control/player_api/device_book.h"

#include <algorithm>
#include <utility>

namespace murosimf::player_api {

using client::DeviceKind;

DeviceBook::DeviceBook(std::vector<client::DeviceDescription> devices) : devices_(std::move(devices)) {
  for (int i = 0; i < count(); ++i) by_name_.emplace(device(i).name, i);
}

int DeviceBook::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? -1 : found->second;
}

int DeviceBook::findKind(std::string_view name, DeviceKind kind) const {
  const int index = find(name);
  return index >= 0 && device(index).kind == kind ? index : -1;
}

int DeviceBook::findMotor(std::string_view name) const { return findKind(name, DeviceKind::kMotor); }
int DeviceBook::findCamera(std::string_view name) const { return findKind(name, DeviceKind::kCamera); }

int DeviceBook::motorOf(int joint) const {
  for (int i = 0; i < count(); ++i) {
    if (device(i).kind == DeviceKind::kMotor && device(i).part == joint) return i;
  }
  return -1;
}

double deviceValue(const client::DeviceDescription& device, double value) {
  return std::clamp(device.offset + device.scale * value, device.lowest, device.highest);
}

double simulatedValue(const client::DeviceDescription& device, double told) {
  return (told - device.offset) / device.scale;
}

}  // namespace murosimf::player_api
