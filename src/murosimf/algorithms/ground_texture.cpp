#include "murosimf/algorithms/ground_texture.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace murosimf {
namespace {

using Light = std::array<double, 3>;

std::uint32_t wordOf(const Light& c) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 3; ++k) word |= static_cast<std::uint32_t>(c[k] + 0.5) << (8 * k);
  return word;
}

struct Picture8 {
  int width, height;
  std::span<const std::uint8_t> rgb;
  double at(int column, int row, std::size_t k) const {
    return rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column)) +
               k];
  }
};

/// Mean over the part of the picture that texel (column, row) of a square of `side` covers.
Light meanOver(const Picture8& from, int side, int column, int row) {
  const double x0 = static_cast<double>(column) * from.width / side,
               x1 = static_cast<double>(column + 1) * from.width / side;
  const double y0 = static_cast<double>(row) * from.height / side,
               y1 = static_cast<double>(row + 1) * from.height / side;
  Light sum{};
  double area = 0;
  for (int v = static_cast<int>(y0); v < from.height && v < y1; ++v)
    for (int u = static_cast<int>(x0); u < from.width && u < x1; ++u) {
      const double part =
          (std::min(u + 1.0, x1) - std::max<double>(u, x0)) * (std::min(v + 1.0, y1) - std::max<double>(v, y0));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += part * from.at(u, v, k);
      area += part;
    }
  for (double& c : sum) c /= area;
  return sum;
}

/// Means of four texels of a square each.
std::vector<Light> halved(const std::vector<Light>& from, int side) {
  std::vector<Light> to;
  for (int row = 0; row + 1 < side; row += 2)
    for (int column = 0; column + 1 < side; column += 2) {
      Light mean{};
      for (const int place : {0, 1, side, side + 1})
        for (std::size_t k = 0; k < 3; ++k)
          mean[k] += 0.25 * from[static_cast<std::size_t>(row * side + column + place)][k];
      to.push_back(mean);
    }
  return to;
}

}  // namespace

GroundTexture::GroundTexture(int width, int height, std::span<const std::uint8_t> rgb) {
  if (width < 1 || height < 1 || rgb.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::invalid_argument("ground texture: width, height and bytes do not belong together");
  int largest = 1;
  while (largest < std::max(width, height) && largest < kLargestSide) largest *= 2;
  const Picture8 from{width, height, rgb};
  std::vector<Light> now;  // means are taken of means that are not yet rounded
  for (int row = 0; row < largest; ++row)
    for (int column = 0; column < largest; ++column) now.push_back(meanOver(from, largest, column, row));
  for (int side = largest; side > 0; side /= 2) {
    first_.push_back(static_cast<std::uint32_t>(texels_.size()));
    for (const Light& c : now) texels_.push_back(wordOf(c));
    now = halved(now, side);
  }
}

}  // namespace murosimf
