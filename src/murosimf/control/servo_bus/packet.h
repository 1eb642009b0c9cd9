#pragma once

/// @file Packets of the servo bus: what is asked of servos and what they answer, in both versions of the protocol.
///
/// 1.0  FF FF id length instruction parameters checksum; length counts from the instruction to the checksum, which is
///      the complement of the sum of all bytes behind the header.
/// 2.0  FF FF FD 00 id length(2) instruction parameters crc(2), numbers with the low byte first. Where FF FF FD comes
///      up behind the length another FD is stuffed in. The CRC-16 has the polynomial 0x8005, starts at 0 and reflects
///      nothing; it covers all bytes before it.
/// An answer has the error in the place of the instruction (1.0), or 0x55 and then the error (2.0).
/// Source: ROBOTIS e-Manual, pages "DYNAMIXEL Protocol 1.0", "DYNAMIXEL Protocol 2.0" and "CRC Calculation".

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace murosimf::servo_bus {

enum class Protocol : std::uint8_t { k1 = 1, k2 = 2 };

enum class Instruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kRegWrite = 0x04,
  kAction = 0x05,
  kFactoryReset = 0x06,
  kReboot = 0x08,
  kClear = 0x10,
  kStatus = 0x55,
  kSyncRead = 0x82,
  kSyncWrite = 0x83,
  kFastSyncRead = 0x8A,
  kBulkRead = 0x92,
  kBulkWrite = 0x93,
  kFastBulkRead = 0x9A
};

inline constexpr std::uint8_t kBroadcast = 0xFE;

/// Bytes of a whole packet of version 2.0, beyond which a length is taken for noise: as much as ROBOTIS' own software
/// sends or expects. One of version 1.0 has at most 259.
inline constexpr std::size_t kLargestPacket = 1024;

struct InstructionPacket {
  std::uint8_t id = 0;
  std::uint8_t instruction = 0;          ///< as sent, also where it is no Instruction
  std::vector<std::uint8_t> parameters;  ///< without stuffing
  bool damaged = false;                  ///< the checksum is not that of the bytes; parameters are left out
};

using Bytes = std::vector<std::uint8_t>;

/// Complement of the low byte of the sum.
std::uint8_t checksum1(std::span<const std::uint8_t> bytes);
std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t start = 0);

/// Appends a packet; `code` is the instruction of a question of either version.
void appendInstruction(Protocol protocol, std::uint8_t id, std::uint8_t code, std::span<const std::uint8_t> parameters,
                       Bytes& out);
/// Appends an answer.
void appendStatus(Protocol protocol, std::uint8_t id, std::uint8_t error, std::span<const std::uint8_t> parameters,
                  Bytes& out);

}  // namespace murosimf::servo_bus
