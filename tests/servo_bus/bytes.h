#pragma once

/// @file Bytes of packets as the manual prints them.

#include <fmt/format.h>

#include <sstream>
#include <string>

#include "murosimf/control/servo_bus/packet.h"

namespace murosimf::servo_bus {

/// Of text as "FF FF 01 02".
inline Bytes bytes(const std::string& text) {
  Bytes result;
  std::istringstream stream(text);
  for (unsigned byte = 0; stream >> std::hex >> byte;) result.push_back(static_cast<std::uint8_t>(byte));
  return result;
}

inline std::string text(const Bytes& bytes) {
  std::string result;
  for (const std::uint8_t byte : bytes) result += fmt::format("{}{:02X}", result.empty() ? "" : " ", byte);
  return result;
}

}  // namespace murosimf::servo_bus
