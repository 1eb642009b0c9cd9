#pragma once

/// @file Control tables: which registers a device has, where, and what may be written there.
///
/// Numbers have the low byte first; signed ones are two's complement (2.0), or carry their sign in bit 10 (1.0).
/// Figures of a servo are those at 12 V; torque and speed go with the voltage.
/// Source: ROBOTIS e-Manual, pages "MX-28", "MX-64", "MX-106" (each also with "(2.0)"), "XH540-W150", "XH540-W270",
/// and for the board with an inertial measurement unit the firmware of github.com/bit-bots/bitbots_imu_dxl.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control/servo_bus/packet.h"

namespace murosimf::servo_bus {

/// What a register means to the simulator; kStored ones are kept and given back, nothing else.
enum class Item : std::uint8_t {
  kStored,
  kModelNumber,
  kFirmwareVersion,
  kId,
  kReturnDelayTime,
  kDriveMode,
  kOperatingMode,
  kSecondaryId,
  kHomingOffset,
  kMovingThreshold,
  kTemperatureLimit,
  kLargestVoltage,
  kLeastVoltage,
  kPwmLimit,
  kCurrentLimit,
  kVelocityLimit,
  kLargestPosition,
  kLeastPosition,
  kShutdown,
  kTorqueEnable,
  kStatusReturnLevel,
  kRegistered,
  kHardwareError,
  kVelocityP,
  kPositionD,
  kPositionP,
  kBusWatchdog,
  kGoalPwm,
  kGoalCurrent,
  kGoalVelocity,
  kProfileAcceleration,
  kProfileVelocity,
  kGoalPosition,
  kRealtimeTick,
  kMoving,
  kMovingStatus,
  kPresentPwm,
  kPresentLoad,
  kPresentCurrent,
  kPresentVelocity,
  kPresentPosition,
  kVelocityTrajectory,
  kPositionTrajectory,
  kPresentVoltage,
  kPresentTemperature,
  // of version 1.0 alone
  kLargestTorque,
  kTorqueLimit,
  kMultiTurnOffset,
  kLock,
  kTorqueMode,
  kGoalTorque,
  kGoalAcceleration,
  // of the board with an inertial measurement unit: floats
  kGyroX,
  kGyroY,
  kGyroZ,
  kAccelerometerX,
  kAccelerometerY,
  kAccelerometerZ,
  kOrientationX,
  kOrientationY,
  kOrientationZ,
  kOrientationW,
  kGyroRange,
  kAccelerometerRange,
  kAccelerometerGain,
  kCount
};

enum class Access : std::uint8_t { kRead, kReadWrite };

struct Register {
  std::uint16_t address = 0;
  std::uint8_t size = 1;  ///< [bytes]
  const char* name = "";
  Access access = Access::kRead;
  std::int64_t initial = 0;
  std::int64_t least = 0, most = 0;  ///< that may be written; a signed register has least < 0
  const char* unit = "";
  Item item = Item::kStored;
  bool is_signed = false;  ///< two's complement
};

/// Registers that show others: data k stands for the byte whose address is in the k-th address register.
struct IndirectBlock {
  std::uint16_t addresses = 0, data = 0;  ///< of the first of each
  std::uint16_t count = 0;
};

/// What the motor and gear of a servo can do at 12 V, and its units.
struct ServoFigures {
  double stall_torque = 0;   ///< [N m]
  double stall_current = 0;  ///< [A]
  double no_load_speed = 0;  ///< [rad/s]
  double current_unit = 0;   ///< [A]; 0: it measures none
  double velocity_unit = 0;  ///< [rad/s]
};

enum class DeviceKind : std::uint8_t { kServo, kImu };

struct ControlTable {
  std::string model;
  DeviceKind kind = DeviceKind::kServo;
  bool old = false;  ///< the table of version 1.0 of a servo: angle limits choose the mode, signs in bit 10
  std::vector<Register> registers;  ///< by address
  std::vector<IndirectBlock> indirect;
  std::uint16_t ram = 0;  ///< address from which on registers are not kept when the device starts again
  std::uint16_t end = 0;  ///< behind the last register
  ServoFigures figures;
};

/// Names that tableOf() knows.
std::vector<std::string_view> modelNames();
/// @throws std::invalid_argument for a model that is not known, or that does not speak this version.
ControlTable tableOf(std::string_view model, Protocol protocol);

}  // namespace murosimf::servo_bus
