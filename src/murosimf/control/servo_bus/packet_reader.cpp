#include "murosimf/control/servo_bus/packet_reader.h"

#include <algorithm>
#include <array>

namespace murosimf::servo_bus {

namespace {

constexpr std::array<std::uint8_t, 4> kHeader = {0xFF, 0xFF, 0xFD, 0x00};
constexpr std::size_t kSizeAhead1 = 4, kSizeAhead2 = 7;  // bytes up to the length, with it

/// Instruction and parameters of a packet of version 2.0: what was stuffed in is left out.
Bytes withoutStuffing(std::span<const std::uint8_t> body) {
  Bytes plain;
  for (std::size_t i = 0; i < body.size(); ++i) {
    plain.push_back(body[i]);
    const bool stuffed = i >= 2 && body[i - 2] == 0xFF && body[i - 1] == 0xFF && body[i] == 0xFD;
    if (stuffed && i + 1 < body.size() && body[i + 1] == 0xFD) ++i;
  }
  return plain;
}

}  // namespace

bool PacketReader::startsWithHeader() const {
  const std::size_t header = protocol_ == Protocol::k1 ? 2 : 4;
  const std::size_t known = std::min(header, bytes_.size());
  if (!std::equal(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(known), kHeader.begin())) return false;
  return protocol_ == Protocol::k2 || bytes_.size() < 3 || bytes_[2] != 0xFF;  // 1.0: a third FF is no id
}

std::optional<std::size_t> PacketReader::expectedSize() const {
  const std::size_t ahead = protocol_ == Protocol::k1 ? kSizeAhead1 : kSizeAhead2;
  if (bytes_.size() < ahead) return ahead;
  const std::size_t length = protocol_ == Protocol::k1 ? bytes_[3] : bytes_[5] + 256u * bytes_[6];
  const std::size_t least = protocol_ == Protocol::k1 ? 2 : 3;
  if (length < least || ahead + length > kLargestPacket) return std::nullopt;
  return ahead + length;
}

InstructionPacket PacketReader::decode(std::size_t size) const {
  const Bytes raw(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
  const std::span all(raw);
  InstructionPacket packet;
  if (protocol_ == Protocol::k1) {
    packet.id = raw[2], packet.instruction = raw[4];
    packet.damaged = checksum1(all.subspan(2, size - 3)) != raw.back();
    if (!packet.damaged) packet.parameters.assign(raw.begin() + 5, raw.end() - 1);
    return packet;
  }
  packet.id = raw[4], packet.instruction = raw[7];
  packet.damaged = crc16(all.first(size - 2)) != raw[size - 2] + 256u * raw[size - 1];
  if (packet.damaged) return packet;
  const Bytes body = withoutStuffing(all.subspan(kSizeAhead2, size - kSizeAhead2 - 2));
  packet.parameters.assign(body.begin() + 1, body.end());
  return packet;
}

std::optional<InstructionPacket> PacketReader::next() {
  while (!bytes_.empty()) {
    const std::optional<std::size_t> size = startsWithHeader() ? expectedSize() : std::nullopt;
    if (!size) {
      bytes_.pop_front();
      continue;
    }
    if (bytes_.size() < *size || *size == (protocol_ == Protocol::k1 ? kSizeAhead1 : kSizeAhead2)) return std::nullopt;
    InstructionPacket packet = decode(*size);
    const std::size_t done = packet.damaged ? 1 : *size;
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(done));
    return packet;
  }
  return std::nullopt;
}

void PacketReader::giveUp() {
  if (!bytes_.empty()) bytes_.pop_front();
}

}  // namespace murosimf::servo_bus
