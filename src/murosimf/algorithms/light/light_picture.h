#pragma once

/// @file The light that reaches the image sensor, before it becomes bytes: one plane of numbers a colour.
///
/// 1 is what a sensor of gain 1 shows as 255; brighter light is kept. Row 0 on top, rows one after another.

#include <array>
#include <cstddef>
#include <vector>

namespace murosimf {

struct LightPicture {
  int width = 0, height = 0;                ///< [px]; set by resize()
  std::array<std::vector<float>, 3> plane;  ///< red, green, blue; longer than the picture by what fills whole registers

  /// Makes room; memory of earlier pictures is used again. Numbers are whatever they were.
  void resize(int new_width, int new_height) {
    width = new_width, height = new_height;
    for (std::vector<float>& p : plane) p.resize(paddedPixels());
  }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  /// The next multiple of kTogether.
  std::size_t paddedPixels() const { return (pixels() + kTogether - 1) / kTogether * kTogether; }

  static constexpr std::size_t kTogether = 16;  ///< lanes of the widest register
};

}  // namespace murosimf
