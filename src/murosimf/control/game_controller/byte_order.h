#pragma once

/// @file Private to the packets: numbers in little endian, one behind the other.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace murosimf::game_controller {

class LittleEndianWriter {
 public:
  void text(std::string_view value) { bytes_.insert(bytes_.end(), value.begin(), value.end()); }
  /// The nearest number from 0 to 255.
  void u8(int value) { bytes_.push_back(static_cast<std::uint8_t>(std::clamp(value, 0, 0xFF))); }
  void u16(int value) { two(static_cast<std::uint16_t>(std::clamp(value, 0, 0xFFFF))); }
  void i16(int value) { two(static_cast<std::uint16_t>(std::clamp(value, -0x8000, 0x7FFF))); }
  void f32(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(bits >> shift));
  }
  void zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void two(std::uint16_t value) {
    bytes_.push_back(static_cast<std::uint8_t>(value & 0xFF));
    bytes_.push_back(static_cast<std::uint8_t>(value >> 8));
  }
  std::vector<std::uint8_t> bytes_;
};

/// The caller has checked that there are bytes enough.
class LittleEndianReader {
 public:
  explicit LittleEndianReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  void skip(std::size_t count) { place_ += count; }
  int u8() { return bytes_[place_++]; }
  int u16() {
    const int low = u8();
    return low | u8() << 8;
  }
  int i16() { return static_cast<std::int16_t>(u16()); }
  float f32() {
    std::uint32_t bits = 0;
    for (int shift = 0; shift < 32; shift += 8) bits |= static_cast<std::uint32_t>(u8()) << shift;
    return std::bit_cast<float>(bits);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

}  // namespace murosimf::game_controller
