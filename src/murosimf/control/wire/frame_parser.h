#pragma once

/// @file Cuts a stream of bytes into frames: a length of four bytes, the highest first, then so many bytes.
///
/// Bytes may come in any pieces. A length is looked at before anything is kept, and what is kept never exceeds the
/// bytes that have come: a client that announces 4 GiB costs nothing.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace murosimf {

class FrameParser {
 public:
  static constexpr std::size_t kHeader = 4;  ///< bytes of the length

  /// @param largest  bytes that a frame may have
  explicit FrameParser(std::size_t largest) : largest_(largest) {}

  /// Takes bytes from the front of `bytes` until a frame is whole or none are left.
  /// @returns true when frame() is whole; call again for those that are left
  bool take(std::span<const std::uint8_t>& bytes);
  /// The frame that is whole, until the next take().
  const std::vector<std::uint8_t>& frame() const { return frame_; }
  std::vector<std::uint8_t>& frame() { return frame_; }

  /// Whether a length above `largest` was announced: where the next frame begins is not known any more.
  bool isLost() const { return lost_; }
  /// The length that was announced last.
  std::size_t announced() const { return announced_; }
  /// Begins anew, with another stream.
  void reset();

 private:
  bool takeHeader(std::span<const std::uint8_t>& bytes);

  std::size_t largest_, announced_ = 0, header_bytes_ = 0;
  bool whole_ = false, lost_ = false;
  std::vector<std::uint8_t> frame_;
};

/// The length of a frame as it goes before it.
inline void writeFrameHeader(std::size_t length, std::uint8_t* header) {
  for (int i = 0; i < 4; ++i) header[i] = static_cast<std::uint8_t>(length >> (24 - 8 * i));
}

}  // namespace murosimf
