#pragma once

/// @file Drawing into the colours of a picture: lines, circles, rectangles and small text.
///
/// Coordinates are pixels, u to the right, v downwards, pixel centres at integers. What lies outside the picture is
/// cut off; coordinates that are not finite draw nothing. Lines are one pixel wide, without smoothing.

#include <cstdint>
#include <string_view>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/algorithms/picture.h"

namespace murosimf {

struct Rgb {
  std::uint8_t red = 255, green = 255, blue = 255;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

class Canvas {
 public:
  /// Draws into this picture, which must live as long.
  explicit Canvas(Picture& picture) : picture_(picture) {}

  int width() const { return picture_.width; }
  int height() const { return picture_.height; }

  void pixel(int u, int v, Rgb colour);
  void line(ImagePoint a, ImagePoint b, Rgb colour);
  void circle(ImagePoint centre, double radius, Rgb colour);
  /// A cross + of two lines, each twice half_size long.
  void cross(ImagePoint centre, double half_size, Rgb colour);
  /// The outline between two opposite corners.
  void rectangle(ImagePoint a, ImagePoint b, Rgb colour);
  /// Mixes a colour into the rectangle's pixels: share 1 covers, share 0 changes nothing.
  void fill(ImagePoint a, ImagePoint b, Rgb colour, double share = 1.0);

  /// Text whose upper left pixel is (u, v); every dot of a letter is a square of `scale` pixels. See bitmap_font.h.
  void text(int u, int v, std::string_view words, Rgb colour, int scale = 1);
  /// Same, on a dark ground that keeps it readable, moved where needed so that all of it is in the picture.
  void label(ImagePoint near, std::string_view words, Rgb colour, int scale = 1);
  /// A dark bar along the lower edge of the picture with text in it.
  void caption(std::string_view words, int scale = 1);

  /// Extent of a text [px]: letters are 6 dots apart, 7 dots high.
  static int textWidth(std::string_view words, int scale = 1);
  static int textHeight(int scale = 1);
  /// Height of caption()'s bar [px].
  static int captionHeight(int scale = 1) { return textHeight(scale) + 6 * scale; }

 private:
  Picture& picture_;
};

}  // namespace murosimf
