#pragma once

/// @file Small letters for pictures: digits, capitals and a few signs, 5 columns by 7 rows each.

#include <array>
#include <cstdint>

namespace murosimf {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

/// Rows from the top; bit 4 is the left column, bit 0 the right one.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;

/// The glyph of a character. Small letters show as capitals; what the font lacks shows as a hollow box.
const Glyph& glyphOf(char character);

}  // namespace murosimf
