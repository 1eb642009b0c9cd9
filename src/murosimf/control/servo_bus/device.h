#pragma once

/// @file One device on the bus: the bytes of its control table, and what may be done to them.
///
/// A range of addresses may be read where it holds a register; what lies between registers reads as 0. A write is
/// checked as a whole before any of it counts: each register must be there in full (version 1.0 lets single bytes
/// pass), be writable, and take a value within its range and within the limits that other registers set. Registers
/// that outlive a restart can be written only while torque is off (2.0), or until Lock is set (1.0).
/// Cost       reads and writes are linear in the registers of the table for finding the first one, and in the bytes.

#include <span>
#include <utility>

#include "murosimf/control/servo_bus/control_table.h"
#include "murosimf/math/state_archive.h"

namespace murosimf::servo_bus {

enum class Fault : std::uint8_t { kNone, kResult, kInstruction, kChecksum, kRange, kLength, kLimit, kAccess, kAngle };

/// Modes of version 2.0; those of 1.0 are told in the same words.
enum class OperatingMode : std::uint8_t {
  kCurrent = 0,
  kVelocity = 1,
  kPosition = 3,
  kExtendedPosition = 4,
  kCurrentPosition = 5,
  kPwm = 16
};

/// Bits of Hardware Error Status, which are those of the error of version 1.0 as well.
inline constexpr std::int64_t kVoltageError = 0x01, kOverheating = 0x04, kOverload = 0x20;

class Device {
 public:
  Device(ControlTable table, std::uint8_t id, std::uint8_t return_delay);

  const ControlTable& table() const { return table_; }
  std::uint8_t id() const { return static_cast<std::uint8_t>(get(Item::kId)); }
  /// The mode, of version 1.0 from the angle limits and the torque mode.
  OperatingMode mode() const;
  bool torqueEnabled() const { return get(Item::kTorqueEnable) != 0; }
  /// 0 answers pings alone, 1 reads as well, 2 everything.
  std::int64_t statusReturnLevel() const { return has(Item::kStatusReturnLevel) ? get(Item::kStatusReturnLevel) : 2; }

  bool has(Item item) const { return places_[static_cast<std::size_t>(item)] >= 0; }
  /// 0 where the table has no such register.
  std::int64_t get(Item item) const;
  /// What the device itself writes: unchecked, cut to the size of the register. Nothing where there is none.
  void set(Item item, std::int64_t value);
  void setFloat(Item item, double value);
  double getFloat(Item item) const;

  Fault read(std::uint16_t address, std::uint16_t length, Bytes& out) const;
  Fault write(std::uint16_t address, std::span<const std::uint8_t> data);
  /// Keeps a write until action(). @returns what write() would, without writing
  Fault registerWrite(std::uint16_t address, std::span<const std::uint8_t> data);
  Fault action();
  /// @param option  0xFF all, 1 all but the id, 2 all but id and baud rate; of version 1.0 always 0xFF
  Fault factoryReset(std::uint8_t option);
  /// Starts again: what does not outlive it takes its initial values.
  void reboot();
  /// Clears the turns that it has counted, by version 2.0's parameters. @returns kResult while it moves
  Fault clear(std::span<const std::uint8_t> parameters);

  /// The byte that an answer carries.
  std::uint8_t errorByte(Protocol protocol, Fault fault) const;
  /// Bits of kVoltageError and its kind, in the answers and in Hardware Error Status.
  void setAlarms(std::int64_t alarms);
  std::int64_t alarms() const { return alarms_; }
  /// Counts writes of goals.
  std::uint32_t goalWrites() const { return goal_writes_; }
  /// Told apart by the counter: who follows the device must take up its position anew.
  std::uint32_t restarts() const { return restarts_; }
  /// A packet has passed on the bus.
  void hear() { heard_ = true; }
  /// Whether one has since the last call.
  bool takeHeard() { return std::exchange(heard_, false); }

  void archive(StateArchive& archive);

 private:
  struct Waiting {
    std::uint16_t address = 0;
    Bytes data;
    void archive(StateArchive& a) { a(address, data); }
  };
  const Register* registerAt(std::uint16_t address) const;
  std::uint16_t resolved(std::uint16_t address) const;
  std::int64_t valueAt(const Register& r, std::span<const std::uint8_t> image) const;
  Fault check(std::uint16_t address, std::span<const std::uint8_t> data) const;
  Fault checkRegister(const Register& r, std::span<const std::uint8_t> image) const;
  Fault checkGoal(const Register& r, std::int64_t value) const;
  bool isLocked(const Register& r) const;
  void follow(Item item, std::int64_t before);
  void followMode();
  void initialise(std::uint16_t first);

  ControlTable table_;
  std::vector<std::int16_t> places_;  // of items: index into registers; -1
  Bytes image_;
  Waiting waiting_;
  std::int64_t alarms_ = 0;
  std::uint32_t goal_writes_ = 0, restarts_ = 0;
  bool heard_ = false;
};

bool isGoal(Item item);

}  // namespace murosimf::servo_bus
