#include "player/vision/colours.h"

namespace murosimf::controllers {
namespace {

/// Between red and yellow: hue (g - b) / (r - b).
Colour betweenRedAndYellow(int r, int g, int b) {
  const int hue = 100 * (g - b) / (r - b);
  return hue < 12 ? Colour::kRed : hue < 66 ? Colour::kOrange : Colour::kYellow;
}

}  // namespace

Colour saturatedColour(int r, int g, int b) {
  if (r >= g && r >= b) {
    if (g >= b) return betweenRedAndYellow(r, g, b);
    return 4 * (b - g) > r - g ? Colour::kMagenta : Colour::kRed;
  }
  if (g >= b) {  // green is highest: only where noise or saturation made it so
    if (r > b) return 5 * (r - b) > 3 * (g - b) ? Colour::kYellow : Colour::kOther;
    return 5 * (b - r) > 3 * (g - r) ? Colour::kCyan : Colour::kOther;
  }
  if (g >= r) return 2 * (g - r) < b - r ? Colour::kBlue : Colour::kCyan;
  return 2 * (r - g) > b - g ? Colour::kMagenta : Colour::kBlue;
}

}  // namespace murosimf::controllers
