#pragma once

/// @file Finds packets in a stream of bytes, however it is cut.
///
/// What is no header is skipped. A length that no packet has (below 2 or 3, or beyond kLargestPacket) makes the header
/// noise, so no more than one packet is ever stored. A packet whose checksum is wrong is told of once, and what follows
/// its first byte is searched again: a packet that begins within a damaged one is not lost.

#include <deque>
#include <optional>

#include "murosimf/control/servo_bus/packet.h"

namespace murosimf::servo_bus {

class PacketReader {
 public:
  explicit PacketReader(Protocol protocol) : protocol_(protocol) {}

  /// Takes bytes as they came. Call next() until it has nothing more before the next ones.
  void take(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  /// The next packet of those bytes.
  std::optional<InstructionPacket> next();
  /// Nothing has come for a while: the packet that was begun will not be finished. What follows its first byte is
  /// searched for others.
  void giveUp();
  /// Bytes of a packet that is not there as a whole yet.
  std::size_t pending() const { return bytes_.size(); }

 private:
  bool startsWithHeader() const;
  /// Bytes of the packet at the front, as far as they can be told; nothing where no packet begins there.
  std::optional<std::size_t> expectedSize() const;
  InstructionPacket decode(std::size_t size) const;

  Protocol protocol_;
  std::deque<std::uint8_t> bytes_;
};

}  // namespace murosimf::servo_bus
