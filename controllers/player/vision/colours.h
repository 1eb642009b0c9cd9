#pragma once

/// @file Which colour a pixel has, by proportions of red, green and blue, so that the light's strength cancels.
///
/// A lamp's strength, the camera's gain and the shading of a surface multiply all three channels alike; what is left
/// unchanged is their proportion. Noise does not scale with them, hence small absolute limits for dark pixels. What
/// cannot be told by proportions (white lines from grey robots) is told by brightness relative to the carpet of the
/// same picture, and how green the carpet is is learnt from the picture, too.

#include <cstdint>

namespace murosimf::controllers {

enum class Colour : std::uint8_t { kOther, kGreen, kWhite, kOrange, kYellow, kBlue, kMagenta, kCyan, kRed };

/// What a picture's carpet looks like; limits of the classes in it.
struct FieldColours {
  double green_level = 110;  ///< mean green channel of the carpet [0, 255]
  double green_share = 0.3;  ///< mean (G - max(R, B)) / (R + G + B) of the carpet

  /// Integer limits derived from them: share of 256 that is green, lowest channel that is white.
  int green_limit = 38, white_limit = 182;

  /// A carpet pixel has at least half of the mean share; white is at least 1.65 times as bright as the carpet (white
  /// paint 2, light grey 1.4), or nearly saturated.
  void derive() {
    const double white = 1.65 * green_level;
    green_limit = static_cast<int>(128 * green_share);
    white_limit = static_cast<int>(white < 232 ? white : 232);
  }
};

inline int greenExcess(int r, int g, int b) { return g - (r > b ? r : b); }

inline bool isGreen(const std::uint8_t* rgb, const FieldColours& field) {
  const int r = rgb[0], g = rgb[1], b = rgb[2];
  const int excess = greenExcess(r, g, b);
  return excess > 9 && excess * 256 > field.green_limit * (r + g + b);
}

/// Colours by hue, for a pixel that is saturated. The hue is the middle channel's place between the lowest and the
/// highest: red .05, orange .4, yellow .85, blue .2, cyan .9, magenta .5.
Colour saturatedColour(int r, int g, int b);

/// The class of a pixel.
inline Colour classify(const std::uint8_t* rgb, const FieldColours& field) {
  if (isGreen(rgb, field)) return Colour::kGreen;
  const int r = rgb[0], g = rgb[1], b = rgb[2];
  const int high = r > g ? (r > b ? r : b) : (g > b ? g : b);
  const int low = r < g ? (r < b ? r : b) : (g < b ? g : b);
  if (high - low > 28 && (high - low) * 4 > r + g + b) return saturatedColour(r, g, b);
  const bool edge_of_line = g > field.green_level && 20 * greenExcess(r, g, b) > r + g + b;  // half paint, half carpet
  return low >= field.white_limit || edge_of_line ? Colour::kWhite : Colour::kOther;
}

/// A weighted sum of the channels that is large on one colour and small on what may surround it.
struct Signal {
  int r = 0, g = 0, b = 0;
  int of(const std::uint8_t* rgb) const { return r * rgb[0] + g * rgb[1] + b * rgb[2]; }
};
inline constexpr Signal kOrangeSignal{1, -1, 0}, kYellowSignal{1, 0, -1}, kBlueSignal{-1, 0, 1};

}  // namespace murosimf::controllers
