#pragma once

/// @file What a camera delivers: colour, and where wanted depth, label, part and motion of every pixel, row 0 on top,
/// and the boxes about what is seen.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace murosimf {

/// Labels that are no drawable's.
inline constexpr std::uint16_t kGroundLabel = 0, kSkyLabel = 65535;
/// Ground that is painted by half or more, where a picture marks its lines.
inline constexpr std::uint16_t kLineLabel = 65534;
/// Parts that are no drawables.
inline constexpr std::int32_t kGroundPart = -1, kSkyPart = -2;

/// The smallest rectangle of whole pixels that holds all that is seen of a label; ends are part of it.
struct LabelBox {
  std::uint16_t label = 0;
  int u_low = 0, v_low = 0, u_high = 0, v_high = 0;  ///< [px]
  int pixels = 0;                                    ///< that show it
  friend bool operator==(const LabelBox&, const LabelBox&) = default;
};

/// Where a pixel's point moved since the picture before [px]; not a number where it was not to be seen.
struct PixelMotion {
  float u = 0, v = 0;
};

struct Picture {
  int width = 0, height = 0;                 ///< [px]; set by resize()
  bool has_depth = true, has_label = true;   ///< what is wanted besides colour; set before resize()
  bool has_part = false, has_boxes = false;  ///< likewise; boxes bring labels
  bool marks_lines = false;                  ///< painted ground has kLineLabel
  std::vector<std::uint8_t> rgb;             ///< 3 bytes a pixel: 255 times red, green, blue
  std::vector<float> depth;                  ///< distance along the optical axis [m]; infinite for the sky
  std::vector<std::uint16_t> label;          ///< label of the drawable seen, or one of the two above

  std::vector<std::int32_t> part;   ///< number of the drawable seen, or one of the two above
  std::vector<LabelBox> boxes;      ///< of drawables' labels, in rising order; made by castPicture()
  std::vector<PixelMotion> motion;  ///< made by findMotion() (pixel_motion.h)

  /// Makes room; memory of earlier pictures is used again.
  void resize(int new_width, int new_height) {
    width = new_width, height = new_height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    rgb.resize(3 * pixels);
    depth.resize(has_depth ? pixels : 0);
    label.resize(has_label || has_boxes ? pixels : 0);
    part.resize(has_part ? pixels : 0);
  }
  /// Place of pixel (u, v) in depth and label; three times it in rgb.
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
};

}  // namespace murosimf
