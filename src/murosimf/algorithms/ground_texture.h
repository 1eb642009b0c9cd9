#pragma once

/// @file A picture laid on the carpet, kept at every halved size: cameras read it at the size of a pixel's footprint.
///
/// Kept as squares of 2^n texels a side, whatever the picture's own sides: the largest is the smallest square that is
/// not smaller than the picture, at most 2048; each following one is the mean of four texels of the one before.

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/cast_texture_data.h"

namespace murosimf {

class GroundTexture {
 public:
  static constexpr int kLargestSide = 2048;  ///< [texels]

  /// @param rgb  3 bytes a pixel, row 0 on top: red, green, blue
  /// @throws std::invalid_argument unless width and height are positive and rgb has 3 width height bytes
  GroundTexture(int width, int height, std::span<const std::uint8_t> rgb);

  int levels() const { return static_cast<int>(first_.size()); }
  int side(int level) const { return 1 << (levels() - 1 - level); }
  /// 0x00bbggrr of a texel; column to the right, row downwards.
  std::uint32_t texel(int level, int column, int row) const {
    return texels_[first_[static_cast<std::size_t>(level)] + static_cast<std::uint32_t>(row * side(level) + column)];
  }
  CastTexture cast() const { return {texels_.data(), first_.data(), levels()}; }

 private:
  std::vector<std::uint32_t> texels_, first_;
};

}  // namespace murosimf
