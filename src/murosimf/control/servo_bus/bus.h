#pragma once

/// @file The bus: hands packets to the devices and collects their answers.
///
/// A question to one id is answered by the first device with that id; a device whose secondary id it is follows it
/// without an answer (2.0). What is asked of several (sync and bulk read, a ping to all) is answered in the order in
/// which the question names them, pings in that of ids; a device that is missing leaves the others' answers alone,
/// but ends a fast read, whose answers are one packet: there the bytes of a missing device never come. Questions to all
/// are otherwise followed without an answer. Status Return Level 0 answers pings alone, 1 reads as well.
/// Fast reads (0x8A, 0x9A): one packet from id 0xFE whose parameters are, for each device, error, id, data, and the
/// CRC of all bytes up to there; nothing is stuffed. [ROBOTIS DynamixelSDK, group_fast_sync_read]

#include <span>
#include <utility>
#include <vector>

#include "murosimf/control/servo_bus/device.h"

namespace murosimf::servo_bus {

/// Bytes that one device sends, and how long it waits before.
struct Answer {
  Bytes bytes;
  double delay = 0;  ///< [s]
};

class Bus {
 public:
  Bus(Protocol protocol, std::vector<Device> devices) : protocol_(protocol), devices_(std::move(devices)) {}

  Protocol protocol() const { return protocol_; }
  std::vector<Device>& devices() { return devices_; }
  const std::vector<Device>& devices() const { return devices_; }

  /// Follows the packet. @returns the answers, in their order
  std::vector<Answer> handle(const InstructionPacket& packet);

 private:
  using Parameters = std::span<const std::uint8_t>;
  struct Request {
    std::uint8_t id = 0;
    std::uint16_t address = 0, length = 0;
  };
  Device* find(std::uint8_t id);
  void single(const InstructionPacket& packet, std::vector<Answer>& answers);
  Fault execute(Device& device, const InstructionPacket& packet, Bytes& data);
  Fault transfer(Device& device, Instruction instruction, Parameters parameters, Bytes& data);
  Fault readInto(const Device& device, std::uint16_t address, std::uint16_t length, Bytes& data) const;
  std::uint16_t word(Parameters parameters, std::size_t i) const;
  std::vector<Request> readRequests(Instruction instruction, Parameters parameters) const;
  void readMany(const InstructionPacket& packet, std::vector<Answer>& answers);
  void readFast(const InstructionPacket& packet, std::vector<Answer>& answers);
  void syncWrite(Parameters parameters);
  void bulkWrite(Parameters parameters);
  void pingAll(std::vector<Answer>& answers);
  Answer answer(const Device& device, Fault fault, std::span<const std::uint8_t> data) const;

  Protocol protocol_;
  std::vector<Device> devices_;
};

}  // namespace murosimf::servo_bus
