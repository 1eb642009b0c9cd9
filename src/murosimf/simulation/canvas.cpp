#include "murosimf/simulation/canvas.h"

#include <algorithm>
#include <cmath>

#include "murosimf/simulation/bitmap_font.h"

namespace murosimf {

namespace {

constexpr int kAdvance = kGlyphWidth + 1;  // dots from one letter to the next
constexpr double kFarthest = 1e5;          // pixels; lines are cut to this before they are followed
constexpr Rgb kDark{20, 22, 26};

bool isDrawable(ImagePoint p) { return std::fabs(p.u) < kFarthest && std::fabs(p.v) < kFarthest; }

int nearest(double x) { return static_cast<int>(std::floor(x + 0.5)); }

std::uint8_t mix(std::uint8_t below, std::uint8_t above, double share) {
  const double mixed = static_cast<double>(below) + share * (static_cast<double>(above) - static_cast<double>(below));
  return static_cast<std::uint8_t>(nearest(mixed));
}

}  // namespace

void Canvas::pixel(int u, int v, Rgb colour) {
  if (u < 0 || v < 0 || u >= picture_.width || v >= picture_.height) return;
  std::uint8_t* rgb = &picture_.rgb[3 * picture_.index(u, v)];
  rgb[0] = colour.red, rgb[1] = colour.green, rgb[2] = colour.blue;
}

void Canvas::line(ImagePoint a, ImagePoint b, Rgb colour) {
  if (!isDrawable(a) || !isDrawable(b)) return;
  const int steps = nearest(std::max(std::fabs(b.u - a.u), std::fabs(b.v - a.v)));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
    pixel(nearest(a.u + share * (b.u - a.u)), nearest(a.v + share * (b.v - a.v)), colour);
  }
}

void Canvas::circle(ImagePoint centre, double radius, Rgb colour) {
  if (!isDrawable(centre) || !(radius >= 0) || radius > kFarthest) return;
  // One pixel a row in the steep eighths, one a column in the flat ones.
  const int eighth = nearest(radius * 0.70710678118654752);
  for (int i = 0; i <= eighth; ++i) {
    const double along = i, across = std::sqrt(std::max(0.0, radius * radius - along * along));
    for (const double s : {-1.0, 1.0}) {
      for (const double t : {-1.0, 1.0}) {
        pixel(nearest(centre.u + s * across), nearest(centre.v + t * along), colour);
        pixel(nearest(centre.u + t * along), nearest(centre.v + s * across), colour);
      }
    }
  }
}

void Canvas::cross(ImagePoint centre, double half_size, Rgb colour) {
  line({centre.u - half_size, centre.v}, {centre.u + half_size, centre.v}, colour);
  line({centre.u, centre.v - half_size}, {centre.u, centre.v + half_size}, colour);
}

void Canvas::rectangle(ImagePoint a, ImagePoint b, Rgb colour) {
  line(a, {b.u, a.v}, colour);
  line({b.u, a.v}, b, colour);
  line(b, {a.u, b.v}, colour);
  line({a.u, b.v}, a, colour);
}

void Canvas::fill(ImagePoint a, ImagePoint b, Rgb colour, double share) {
  if (!isDrawable(a) || !isDrawable(b)) return;
  const int first_u = std::max(0, nearest(std::min(a.u, b.u)));
  const int last_u = std::min(picture_.width - 1, nearest(std::max(a.u, b.u)));
  const int first_v = std::max(0, nearest(std::min(a.v, b.v)));
  const int last_v = std::min(picture_.height - 1, nearest(std::max(a.v, b.v)));
  for (int v = first_v; v <= last_v; ++v) {
    for (int u = first_u; u <= last_u; ++u) {
      std::uint8_t* rgb = &picture_.rgb[3 * picture_.index(u, v)];
      rgb[0] = mix(rgb[0], colour.red, share);
      rgb[1] = mix(rgb[1], colour.green, share);
      rgb[2] = mix(rgb[2], colour.blue, share);
    }
  }
}

void Canvas::text(int u, int v, std::string_view words, Rgb colour, int scale) {
  for (const char character : words) {
    const Glyph& glyph = glyphOf(character);
    for (int row = 0; row < kGlyphHeight * scale; ++row) {
      const int bits = glyph[static_cast<std::size_t>(row / scale)];
      for (int column = 0; column < kGlyphWidth * scale; ++column) {
        if ((bits >> (kGlyphWidth - 1 - column / scale) & 1) != 0) pixel(u + column, v + row, colour);
      }
    }
    u += kAdvance * scale;
  }
}

void Canvas::label(ImagePoint near, std::string_view words, Rgb colour, int scale) {
  if (!isDrawable(near)) return;
  const int margin = scale + 1, width = textWidth(words, scale), height = textHeight(scale);
  const int u = std::clamp(nearest(near.u), margin, std::max(margin, picture_.width - width - margin));
  const int v = std::clamp(nearest(near.v), margin, std::max(margin, picture_.height - height - margin));
  fill({static_cast<double>(u - margin), static_cast<double>(v - margin)},
       {static_cast<double>(u + width + margin - 1), static_cast<double>(v + height + margin - 1)}, kDark, 0.6);
  text(u, v, words, colour, scale);
}

void Canvas::caption(std::string_view words, int scale) {
  const int top = picture_.height - captionHeight(scale);
  fill({0, static_cast<double>(top)},
       {static_cast<double>(picture_.width - 1), static_cast<double>(picture_.height - 1)}, kDark, 0.75);
  text(4 * scale, top + 3 * scale, words, Rgb{}, scale);
}

int Canvas::textWidth(std::string_view words, int scale) {
  return words.empty() ? 0 : (static_cast<int>(words.size()) * kAdvance - 1) * scale;
}

int Canvas::textHeight(int scale) { return kGlyphHeight * scale; }

}  // namespace murosimf
