#include "murosimf/algorithms/light/pixel_format.h"

#include <algorithm>

namespace murosimf {

namespace {

struct Colour3 {
  float r, g, b;  // 255 = full
};

std::uint8_t toByte(float x) { return static_cast<std::uint8_t>(std::clamp(x + 0.5F, 0.0F, 255.0F)); }

std::size_t index(int i) { return static_cast<std::size_t>(i); }

float luminance(const Colour3& c) { return 0.299F * c.r + 0.587F * c.g + 0.114F * c.b; }

void storePair(const Colour3& first, const Colour3& second, std::uint8_t* out) {
  const Colour3 mean{0.5F * (first.r + second.r), 0.5F * (first.g + second.g), 0.5F * (first.b + second.b)};
  out[0] = toByte(luminance(first));
  out[1] = toByte(128.0F - 0.168736F * mean.r - 0.331264F * mean.g + 0.5F * mean.b);
  out[2] = toByte(luminance(second));
  out[3] = toByte(128.0F + 0.5F * mean.r - 0.418688F * mean.g - 0.081312F * mean.b);
}

/// colourOf(pixel): its colour as whole bytes, so that all formats show the same ones.
template <class ColourOf>
void storeAll(int width, int height, PixelFormat format, std::vector<std::uint8_t>& bytes, const ColourOf& colourOf) {
  bytes.resize(bytesPerRow(format, width) * index(height));
  std::uint8_t* out = bytes.data();
  for (int v = 0; v < height; ++v) {
    const std::size_t first = index(v) * index(width);
    if (format == PixelFormat::kYuyv) {
      for (int u = 0; u < width; u += 2, out += 4) {
        const Colour3 c = colourOf(first + index(u));
        storePair(c, u + 1 < width ? colourOf(first + index(u) + 1) : c, out);
      }
      continue;
    }
    const bool bgr = format == PixelFormat::kBgr;
    for (int u = 0; u < width; ++u, out += 3) {
      const Colour3 c = colourOf(first + index(u));
      out[0] = toByte(bgr ? c.b : c.r), out[1] = toByte(c.g), out[2] = toByte(bgr ? c.r : c.b);
    }
  }
}

}  // namespace

std::optional<PixelFormat> pixelFormatOf(std::string_view name) {
  for (const PixelFormat format : {PixelFormat::kRgb, PixelFormat::kBgr, PixelFormat::kYuyv}) {
    if (name == nameOf(format)) return format;
  }
  return std::nullopt;
}

std::string_view nameOf(PixelFormat format) {
  return format == PixelFormat::kRgb ? "rgb" : format == PixelFormat::kBgr ? "bgr" : "yuyv";
}

std::size_t bytesPerRow(PixelFormat format, int width) {
  return format == PixelFormat::kYuyv ? 4 * index((width + 1) / 2) : 3 * index(width);
}

void storePixels(const LightPicture& light, PixelFormat format, std::vector<std::uint8_t>& bytes) {
  const auto whole = [](float c) { return static_cast<float>(toByte(255.0F * c)); };
  storeAll(light.width, light.height, format, bytes, [&](std::size_t i) {
    return Colour3{whole(light.plane[0][i]), whole(light.plane[1][i]), whole(light.plane[2][i])};
  });
}

void storePixels(const std::vector<std::uint8_t>& rgb, int width, int height, PixelFormat format,
                 std::vector<std::uint8_t>& bytes) {
  if (format == PixelFormat::kRgb) {
    bytes.assign(rgb.begin(), rgb.end());
    return;
  }
  storeAll(width, height, format, bytes, [&](std::size_t i) {
    return Colour3{static_cast<float>(rgb[3 * i]), static_cast<float>(rgb[3 * i + 1]),
                   static_cast<float>(rgb[3 * i + 2])};
  });
}

}  // namespace murosimf
