#pragma once

/// @file Numbers and texts as bytes, little endian, for files.

#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

namespace murosimf {

/// Appends to a buffer that the owner empties. Counterpart: ByteSource.
class ByteWriter {
 public:
  void u8(std::uint8_t x) { bytes_.push_back(x); }
  void u32(std::uint32_t x) { number(x, 4); }
  void u64(std::uint64_t x) { number(x, 8); }
  void f64(double x) { u64(std::bit_cast<std::uint64_t>(x)); }
  /// Length (u32) and characters.
  void text(std::string_view x) {
    u32(static_cast<std::uint32_t>(x.size()));
    bytes_.insert(bytes_.end(), x.begin(), x.end());
  }
  /// Characters alone.
  void raw(std::string_view x) { bytes_.insert(bytes_.end(), x.begin(), x.end()); }
  /// Overwrites four bytes written before.
  void setU32(std::size_t place, std::uint32_t x) {
    for (std::size_t i = 0; i < 4; ++i) bytes_[place + i] = static_cast<std::uint8_t>(x >> (8 * i));
  }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }
  void clear() { bytes_.clear(); }
  void reserve(std::size_t size) { bytes_.reserve(size); }

 private:
  void number(std::uint64_t x, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<std::uint8_t>(x >> (8 * i)));
  }
  std::vector<std::uint8_t> bytes_;
};

}  // namespace murosimf
