#pragma once

/// @file A ground's picture as the ray caster's kernels read it: plain numbers, alike for every instruction set.

#include <cstdint>

namespace murosimf {

struct CastTexture {
  const std::uint32_t* texels;  ///< 0x00bbggrr, level after level, row by row
  const std::uint32_t* first;   ///< of each level, the largest first; level k has (2^(levels - 1 - k))^2
  std::int32_t levels;          ///< 0: no picture
};

}  // namespace murosimf
