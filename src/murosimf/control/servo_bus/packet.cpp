#include "murosimf/control/servo_bus/packet.h"

#include <array>

namespace murosimf::servo_bus {

namespace {

void append(Bytes& out, std::span<const std::uint8_t> bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

void append1(std::uint8_t id, std::span<const std::uint8_t> body, Bytes& out) {
  const std::size_t start = out.size() + 2;
  append(out, std::array<std::uint8_t, 4>{0xFF, 0xFF, id, static_cast<std::uint8_t>(body.size() + 1)});
  append(out, body);
  out.push_back(checksum1(std::span(out).subspan(start)));
}

void append2(std::uint8_t id, std::span<const std::uint8_t> body, Bytes& out) {
  const std::size_t start = out.size();
  append(out, std::array<std::uint8_t, 7>{0xFF, 0xFF, 0xFD, 0x00, id, 0, 0});
  const std::size_t first = out.size();
  for (const std::uint8_t byte : body) {
    out.push_back(byte);
    const std::size_t n = out.size();
    if (n - first >= 3 && out[n - 3] == 0xFF && out[n - 2] == 0xFF && byte == 0xFD) out.push_back(0xFD);
  }
  const std::size_t length = out.size() - first + 2;
  out[first - 2] = static_cast<std::uint8_t>(length);
  out[first - 1] = static_cast<std::uint8_t>(length >> 8);
  const std::uint16_t crc = crc16(std::span(out).subspan(start));
  out.push_back(static_cast<std::uint8_t>(crc));
  out.push_back(static_cast<std::uint8_t>(crc >> 8));
}

}  // namespace

std::uint8_t checksum1(std::span<const std::uint8_t> bytes) {
  unsigned sum = 0;
  for (const std::uint8_t byte : bytes) sum += byte;
  return static_cast<std::uint8_t>(~sum);
}

std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t start) {
  unsigned crc = start;
  for (const std::uint8_t byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000u) != 0 ? (crc << 1) ^ 0x8005u : crc << 1;
    crc &= 0xFFFFu;
  }
  return static_cast<std::uint16_t>(crc);
}

void appendInstruction(Protocol protocol, std::uint8_t id, std::uint8_t code, std::span<const std::uint8_t> parameters,
                       Bytes& out) {
  Bytes body{code};
  append(body, parameters);
  protocol == Protocol::k1 ? append1(id, body, out) : append2(id, body, out);
}

void appendStatus(Protocol protocol, std::uint8_t id, std::uint8_t error, std::span<const std::uint8_t> parameters,
                  Bytes& out) {
  Bytes body;
  if (protocol == Protocol::k2) body.push_back(static_cast<std::uint8_t>(Instruction::kStatus));
  body.push_back(error);
  append(body, parameters);
  protocol == Protocol::k1 ? append1(id, body, out) : append2(id, body, out);
}

}  // namespace murosimf::servo_bus
