#pragma once

/// @file From light to the bytes that a camera's driver hands out.
///
/// Byte = 255 times light, rounded, cut to [0, 255]. Luminance and colour differences after ITU-R BT.601 in full range,
/// as in JFIF and in what webcams call YUYV:
///     Y  = 0.299 R + 0.587 G + 0.114 B
///     Cb = 128 - 0.168736 R - 0.331264 G + 0.5 B,   Cr = 128 + 0.5 R - 0.418688 G - 0.081312 B
/// of two neighbours the mean, a last single column alone.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "murosimf/algorithms/light/light_picture.h"

namespace murosimf {

enum class PixelFormat : std::uint8_t {
  kRgb,   ///< 3 bytes a pixel: red, green, blue
  kBgr,   ///< 3 bytes a pixel: blue, green, red
  kYuyv,  ///< 4 bytes two pixels: Y of the first, Cb, Y of the second, Cr; YUV 4:2:2
};
/// "rgb", "bgr", "yuyv"; nothing for other words.
std::optional<PixelFormat> pixelFormatOf(std::string_view name);
std::string_view nameOf(PixelFormat format);

/// Bytes of a row.
std::size_t bytesPerRow(PixelFormat format, int width);
/// Overwrites bytes, which get their size. Padding of the light is left out.
void storePixels(const LightPicture& light, PixelFormat format, std::vector<std::uint8_t>& bytes);
/// The same from bytes r g b.
void storePixels(const std::vector<std::uint8_t>& rgb, int width, int height, PixelFormat format,
                 std::vector<std::uint8_t>& bytes);

}  // namespace murosimf
