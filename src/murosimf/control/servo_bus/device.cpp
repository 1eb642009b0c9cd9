#include "murosimf/control/servo_bus/device.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <utility>

namespace murosimf::servo_bus {

namespace {

constexpr std::array<std::uint8_t, 5> kClearTurns = {0x01, 0x44, 0x58, 0x4C, 0x22};

std::int64_t decode(std::span<const std::uint8_t> bytes, bool is_signed) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
  const unsigned unused = 64 - 8 * static_cast<unsigned>(bytes.size());
  return is_signed ? static_cast<std::int64_t>(value << unused) >> unused : static_cast<std::int64_t>(value);
}

}  // namespace

bool isGoal(Item item) {
  switch (item) {
    case Item::kGoalPosition:
    case Item::kGoalVelocity:
    case Item::kGoalCurrent:
    case Item::kGoalPwm:
    case Item::kGoalTorque:
      return true;
    default:
      return false;
  }
}

Device::Device(ControlTable table, std::uint8_t id, std::uint8_t return_delay)
    : table_(std::move(table)), places_(static_cast<std::size_t>(Item::kCount), -1), image_(table_.end) {
  for (std::size_t i = 0; i < table_.registers.size(); ++i) {
    const Item item = table_.registers[i].item;
    if (item == Item::kId) table_.registers[i].initial = id;
    if (item == Item::kReturnDelayTime) table_.registers[i].initial = return_delay;
    if (item != Item::kStored) places_[static_cast<std::size_t>(item)] = static_cast<std::int16_t>(i);
  }
  initialise(0);
}

void Device::initialise(std::uint16_t first) {
  for (const Register& r : table_.registers) {
    if (r.address < first) continue;
    for (unsigned i = 0; i < r.size; ++i) image_[r.address + i] = static_cast<std::uint8_t>(r.initial >> (8 * i));
  }
  waiting_ = {};
  alarms_ = 0;
  if (has(Item::kTorqueLimit)) set(Item::kTorqueLimit, get(Item::kLargestTorque));
  if (!table_.old) followMode();
  ++restarts_;
}

OperatingMode Device::mode() const {
  if (!table_.old) return static_cast<OperatingMode>(get(Item::kOperatingMode));
  if (get(Item::kTorqueMode) != 0) return OperatingMode::kCurrent;
  const std::int64_t least = get(Item::kLeastPosition), most = get(Item::kLargestPosition);
  if (least == 0 && most == 0) return OperatingMode::kVelocity;
  return least == 4095 && most == 4095 ? OperatingMode::kExtendedPosition : OperatingMode::kPosition;
}

std::int64_t Device::valueAt(const Register& r, std::span<const std::uint8_t> image) const {
  return decode(image.subspan(r.address, r.size), r.is_signed);
}

std::int64_t Device::get(Item item) const {
  if (!has(item)) return 0;
  return valueAt(table_.registers[static_cast<std::size_t>(places_[static_cast<std::size_t>(item)])], image_);
}

void Device::set(Item item, std::int64_t value) {
  if (!has(item)) return;
  const Register& r = table_.registers[static_cast<std::size_t>(places_[static_cast<std::size_t>(item)])];
  for (unsigned i = 0; i < r.size; ++i) image_[r.address + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

void Device::setFloat(Item item, double value) { set(item, std::bit_cast<std::int32_t>(static_cast<float>(value))); }

double Device::getFloat(Item item) const {
  return static_cast<double>(std::bit_cast<float>(static_cast<std::int32_t>(get(item))));
}

const Register* Device::registerAt(std::uint16_t address) const {
  const auto after = std::upper_bound(table_.registers.begin(), table_.registers.end(), address,
                                      [](std::uint16_t a, const Register& r) { return a < r.address; });
  if (after == table_.registers.begin()) return nullptr;
  const Register& r = *std::prev(after);
  return address < r.address + r.size ? &r : nullptr;
}

std::uint16_t Device::resolved(std::uint16_t address) const {
  for (const IndirectBlock& block : table_.indirect) {
    if (address < block.data || address >= block.data + block.count) continue;
    const std::size_t place = block.addresses + 2u * (address - block.data);
    return static_cast<std::uint16_t>(decode(std::span(image_).subspan(place, 2), false));
  }
  return address;
}

Fault Device::read(std::uint16_t address, std::uint16_t length, Bytes& out) const {
  const Fault refused = table_.old ? Fault::kRange : Fault::kAccess;
  if (length == 0 || address + length > table_.end) return refused;
  bool known = false;
  for (unsigned i = 0; i < length; ++i) known |= registerAt(static_cast<std::uint16_t>(address + i)) != nullptr;
  if (!known) return refused;
  for (unsigned i = 0; i < length; ++i) out.push_back(image_[resolved(static_cast<std::uint16_t>(address + i))]);
  return Fault::kNone;
}

bool Device::isLocked(const Register& r) const {
  if (r.address >= table_.ram) return false;
  return table_.old ? get(Item::kLock) != 0 : torqueEnabled();
}

Fault Device::checkGoal(const Register& r, std::int64_t value) const {
  const auto beyond = [&](std::int64_t limit) { return std::abs(value) > limit ? Fault::kLimit : Fault::kNone; };
  if (!table_.old && get(Item::kBusWatchdog) < 0) return Fault::kRange;
  switch (r.item) {
    case Item::kGoalVelocity:
      return beyond(get(Item::kVelocityLimit));
    case Item::kGoalCurrent:
      return beyond(get(Item::kCurrentLimit));
    case Item::kGoalPwm:
      return beyond(get(Item::kPwmLimit));
    case Item::kGoalPosition: {
      if (mode() != OperatingMode::kPosition) return Fault::kNone;
      const bool inside = value >= get(Item::kLeastPosition) && value <= get(Item::kLargestPosition);
      return inside ? Fault::kNone : table_.old ? Fault::kAngle : Fault::kLimit;
    }
    default:
      return Fault::kNone;
  }
}

Fault Device::checkRegister(const Register& r, std::span<const std::uint8_t> image) const {
  const Fault refused = table_.old ? Fault::kRange : Fault::kAccess;
  if (r.access == Access::kRead || isLocked(r)) return refused;
  const std::int64_t value = valueAt(r, image);
  if (value < r.least || value > r.most) return Fault::kRange;
  if (r.item == Item::kLock && value == 0 && get(Item::kLock) != 0) return Fault::kRange;  // until it starts again
  if (r.item == Item::kOperatingMode) {
    const bool with_current = value == 0 || value == 5;
    const bool known =
        value == 1 || value == 3 || value == 4 || value == 16 || (with_current && has(Item::kGoalCurrent));
    if (!known) return Fault::kRange;
  }
  return isGoal(r.item) ? checkGoal(r, value) : Fault::kNone;
}

Fault Device::check(std::uint16_t address, std::span<const std::uint8_t> data) const {
  const Fault refused = table_.old ? Fault::kRange : Fault::kAccess;
  if (data.empty() || address + data.size() > table_.end) return refused;
  Bytes image = image_;
  for (std::size_t i = 0; i < data.size(); ++i) image[resolved(static_cast<std::uint16_t>(address + i))] = data[i];
  std::vector<const Register*> touched;
  std::vector<unsigned> bytes;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const Register* r = registerAt(resolved(static_cast<std::uint16_t>(address + i)));
    if (r == nullptr) return refused;
    if (touched.empty() || touched.back() != r) touched.push_back(r), bytes.push_back(0);
    ++bytes.back();
  }
  for (std::size_t k = 0; k < touched.size(); ++k) {
    if (!table_.old && bytes[k] != touched[k]->size) return Fault::kLength;
    if (const Fault fault = checkRegister(*touched[k], image); fault != Fault::kNone) return fault;
  }
  return Fault::kNone;
}

Fault Device::write(std::uint16_t address, std::span<const std::uint8_t> data) {
  if (const Fault fault = check(address, data); fault != Fault::kNone) return fault;
  const Register* last = nullptr;
  const Bytes before = image_;
  for (std::size_t i = 0; i < data.size(); ++i) image_[resolved(static_cast<std::uint16_t>(address + i))] = data[i];
  for (std::size_t i = 0; i < data.size(); ++i) {
    const Register* r = registerAt(resolved(static_cast<std::uint16_t>(address + i)));
    if (std::exchange(last, r) != r) follow(r->item, valueAt(*r, before));
  }
  return Fault::kNone;
}

Fault Device::registerWrite(std::uint16_t address, std::span<const std::uint8_t> data) {
  if (const Fault fault = check(address, data); fault != Fault::kNone) return fault;
  waiting_ = {address, Bytes(data.begin(), data.end())};
  set(Item::kRegistered, 1);
  return Fault::kNone;
}

Fault Device::action() {
  if (waiting_.data.empty()) return Fault::kInstruction;
  const Waiting waiting = std::exchange(waiting_, {});
  set(Item::kRegistered, 0);
  return write(waiting.address, waiting.data);
}

Fault Device::factoryReset(std::uint8_t option) {
  const std::uint8_t own_id = id();
  if (option != 0xFF && option != 1 && option != 2) return Fault::kRange;
  Bytes baud;
  read(table_.old ? 4 : 8, 1, baud);
  initialise(0);
  if (option != 0xFF) set(Item::kId, own_id);
  if (option == 2) write(table_.old ? 4 : 8, baud);
  return Fault::kNone;
}

void Device::reboot() { initialise(table_.ram); }

Fault Device::clear(std::span<const std::uint8_t> parameters) {
  if (!std::equal(parameters.begin(), parameters.end(), kClearTurns.begin(), kClearTurns.end())) return Fault::kRange;
  if (get(Item::kMoving) != 0) return Fault::kResult;
  ++restarts_;
  return Fault::kNone;
}

void Device::follow(Item item, std::int64_t before) {
  if (isGoal(item) || (table_.old && item == Item::kProfileVelocity)) ++goal_writes_;
  const bool turned_on = item == Item::kTorqueEnable && before == 0 && torqueEnabled();
  if (turned_on && !table_.old) {
    set(Item::kGoalPosition, get(Item::kPresentPosition));
    set(Item::kGoalVelocity, 0);
  }
  if (item == Item::kOperatingMode) followMode();
  if (item == Item::kHomingOffset || item == Item::kOperatingMode || item == Item::kDriveMode) ++restarts_;
  if (isGoal(item) && !table_.old && (get(Item::kDriveMode) & 0x08) != 0) set(Item::kTorqueEnable, 1);
}

void Device::followMode() {
  const OperatingMode now = mode();
  set(Item::kGoalPwm, now == OperatingMode::kPwm ? 0 : get(Item::kPwmLimit));
  set(Item::kGoalCurrent, now == OperatingMode::kCurrent ? 0 : get(Item::kCurrentLimit));
  set(Item::kGoalVelocity, 0);
}

void Device::setAlarms(std::int64_t alarms) {
  alarms_ = alarms;
  set(Item::kHardwareError, alarms);
}

std::uint8_t Device::errorByte(Protocol protocol, Fault fault) const {
  if (protocol == Protocol::k2) return static_cast<std::uint8_t>(static_cast<int>(fault) | (alarms_ != 0 ? 0x80 : 0));
  constexpr std::array<std::uint8_t, 9> kBits = {0, 0, 0x40, 0x10, 0x08, 0x08, 0x08, 0x08, 0x02};
  return static_cast<std::uint8_t>(kBits[static_cast<std::size_t>(fault)] | alarms_);
}

void Device::archive(StateArchive& archive) { archive(image_, waiting_, alarms_, goal_writes_, restarts_, heard_); }

}  // namespace murosimf::servo_bus
