#pragma once

/// @file What a camera delivers: colour, and where wanted depth and label of every pixel, row 0 on top.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace murosimf {

/// Labels that are no drawable's.
inline constexpr std::uint16_t kGroundLabel = 0, kSkyLabel = 65535;

struct Picture {
  int width = 0, height = 0;                ///< [px]; set by resize()
  bool has_depth = true, has_label = true;  ///< what is wanted besides colour; set before resize()
  std::vector<std::uint8_t> rgb;            ///< 3 bytes a pixel: 255 times red, green, blue
  std::vector<float> depth;                 ///< distance along the optical axis [m]; infinite for the sky
  std::vector<std::uint16_t> label;         ///< label of the drawable seen, or one of the two above

  /// Makes room; memory of earlier pictures is used again.
  void resize(int new_width, int new_height) {
    width = new_width, height = new_height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    rgb.resize(3 * pixels);
    depth.resize(has_depth ? pixels : 0);
    label.resize(has_label ? pixels : 0);
  }
  /// Place of pixel (u, v) in depth and label; three times it in rgb.
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
};

}  // namespace murosimf
