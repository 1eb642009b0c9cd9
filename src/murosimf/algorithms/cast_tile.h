#pragma once

/// @file What the parts of the ray caster's kernel share: the tile being worked on and evaluation of forms.
///
/// A tile's pixels are buffered in planes, row by row, so that all passes work in the first-level cache; the last pass
/// writes bytes. Include in kernels only.

#include "murosimf/algorithms/cast_data.h"
#include "murosimf/algorithms/cast_lanes.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Rows of a tile as bits.
inline constexpr unsigned kAllRows = (1U << kTileSize) - 1;

/// Labels of a tile's pixels that see no drawable. The ground is negative, apart from drawables that have its label 0;
/// it is written as 0.
inline constexpr float kSky = 65535.0F, kLine = 65534.0F, kGround = -1.0F;

/// Everything of 256 pixels: [row][column].
struct alignas(64) TileBuffer {
  float x[kTilePixels], y[kTilePixels];  ///< slopes, when they are not those of the table
  float w[kTilePixels];                  ///< inverse depth of the nearest surface so far
  float red[kTilePixels], green[kTilePixels], blue[kTilePixels];
  float light[kTilePixels];    ///< on what is seen: written for hard shadows only
  float label[kTilePixels];    ///< of the drawable seen, kSky or kGround
  float surface[kTilePixels];  ///< -2 sky, -1 ground, else index: where antialiasing or parts want it
  float carpet[kTilePixels], paint[kTilePixels];  ///< share of the pixel's footprint that is carpet, is painted
};

/// One tile with one ray a pixel.
struct Tile {
  const CastJob& job;
  const CastScene& scene;
  const CastRow& candidates;
  const TileRays& rays;
  const float *x, *y;        ///< slopes of this pass
  float margin_x, margin_y;  ///< how far these slopes may lie outside the ranges of `rays`
  unsigned rows;             ///< to be worked on, as bits
  TileBuffer& buffer;
};

/// Whether TileBuffer::surface is wanted.
inline bool keepsSurfaces(const Tile& tile) { return tile.job.antialias || tile.job.part; }

template <class S>
inline S evaluate(const LinearForm& form, S x, S y) {
  return (S(form.x) * x + S(form.y) * y) + S(form.one);
}
template <class S>
inline S evaluate(const QuadraticForm& form, S x, S y) {
  const S a = x - S(form.x0), b = y - S(form.y0);
  const S of_a = (S(form.xx) * a + S(form.xy) * b) + S(form.x);
  const S of_b = S(form.yy) * b + S(form.y);
  return (of_a * a + of_b * b) + S(form.one);
}

/// The tile's rows that may touch a range of slopes, as bits.
inline unsigned rowsWithin(const Tile& tile, float y_low, float y_high) {
  using Eight = Pack<float, 8>;
  const Eight margin(tile.margin_y), low(y_low), high(y_high);
  unsigned rows = 0;
  for (int first = 0; first < kTileSize; first += 8) {
    const auto touched = (load<Eight>(tile.rays.row_high + first) + margin >= low) &
                         (load<Eight>(tile.rays.row_low + first) - margin <= high);
    rows |= laneBits(touched) << first;
  }
  return rows & tile.rows;
}

/// Calls visit(i) for every pack, i its first pixel's index, of the tile's rows that a rectangle of slopes may touch.
template <class S, class Visit>
inline void forPacksWithin(const Tile& tile, float x_low, float x_high, float y_low, float y_high, Visit visit) {
  constexpr int kHalf = kTileSize / 2, kWidth = Lanes<S>::kWidth;
  int first = 0, last = kTileSize;
  if (tile.rays.column_high[0] + tile.margin_x < x_low || tile.rays.column_low[0] - tile.margin_x > x_high)
    first = kHalf;
  if (tile.rays.column_high[1] + tile.margin_x < x_low || tile.rays.column_low[1] - tile.margin_x > x_high)
    last = kHalf;
  if (kWidth == kTileSize) first = 0, last = first < last ? kTileSize : 0;
  for (unsigned rows = rowsWithin(tile, y_low, y_high); rows != 0; rows &= rows - 1) {
    const int row = __builtin_ctz(rows);
    for (int column = first; column < last; column += kWidth) visit(row * kTileSize + column);
  }
}

/// Calls visit(i) for every pack of the tile's rows.
template <class S, class Visit>
inline void forPacks(const Tile& tile, Visit visit) {
  for (int row = 0; row < kTileSize; ++row) {
    if (!(tile.rows >> row & 1U)) continue;
    for (int column = 0; column < kTileSize; column += Lanes<S>::kWidth) visit(row * kTileSize + column);
  }
}

/// Calls visit(candidate) for each surface of the tile's row whose rectangle meets the tile's, front to back.
template <class S, class Visit>
inline void forCandidates(const Tile& tile, Visit visit) {
  constexpr int kWidth = Lanes<S>::kWidth;
  const S x_low(tile.rays.x_low - tile.margin_x), x_high(tile.rays.x_high + tile.margin_x);
  const S y_low(tile.rays.y_low - tile.margin_y), y_high(tile.rays.y_high + tile.margin_y);
  const CastRow& row = tile.candidates;
  for (int first = 0; first < row.count; first += kWidth) {
    const auto left = load<S>(row.x_low + first) <= x_high, right = load<S>(row.x_high + first) >= x_low;
    const auto below = load<S>(row.y_low + first) <= y_high, above = load<S>(row.y_high + first) >= y_low;
    unsigned found = laneBits(left & right & below & above);
    for (; found != 0; found &= found - 1) visit(first + __builtin_ctz(found));
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
