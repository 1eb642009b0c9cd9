#include "murosimf/algorithms/ray_table.h"

#include <algorithm>

namespace murosimf {
namespace {

/// Ranges of the 256 rays of one tile. A padded ray repeats one of the picture and widens nothing.
void findRanges(const float* x, const float* y, TileRays& tile) {
  constexpr int kHalf = kTileSize / 2;
  for (int half = 0; half < 2; ++half) {
    tile.column_low[half] = tile.column_high[half] = x[half * kHalf];
    for (int i = 0; i < kTilePixels; ++i) {
      if (i % kTileSize / kHalf != half) continue;
      tile.column_low[half] = std::min(tile.column_low[half], x[i]);
      tile.column_high[half] = std::max(tile.column_high[half], x[i]);
    }
  }
  for (int row = 0; row < kTileSize; ++row) {
    const auto [low, high] = std::minmax_element(y + row * kTileSize, y + (row + 1) * kTileSize);
    tile.row_low[row] = *low, tile.row_high[row] = *high;
  }
  tile.x_low = std::min(tile.column_low[0], tile.column_low[1]);
  tile.x_high = std::max(tile.column_high[0], tile.column_high[1]);
  tile.y_low = *std::min_element(tile.row_low, tile.row_low + kTileSize);
  tile.y_high = *std::max_element(tile.row_high, tile.row_high + kTileSize);
}

/// Slopes change by the inverse of d(pixel) / d(slope) = diag(f) skewed * distortion's derivative.
void findPixelSize(const CameraModel& camera, RaySlopes middle, TileRays& tile) {
  const DistortionJacobian j = distortionJacobian(camera, middle);
  const double ux = camera.fx * (j.xx + camera.skew * j.yx), uy = camera.fx * (j.xy + camera.skew * j.yy);
  const double vx = camera.fy * j.yx, vy = camera.fy * j.yy;
  const double determinant = ux * vy - uy * vx;
  tile.x_u = static_cast<float>(vy / determinant), tile.x_v = static_cast<float>(-uy / determinant);
  tile.y_u = static_cast<float>(-vx / determinant), tile.y_v = static_cast<float>(ux / determinant);
}

}  // namespace

RayTable::RayTable(const CameraModel& camera)
    : camera_(camera),
      tile_columns_((camera.width + kTileSize - 1) / kTileSize),
      tile_rows_((camera.height + kTileSize - 1) / kTileSize) {
  checkCamera(camera);
  const double limit = validRadius(camera);
  const auto tile_count = static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>(tile_rows_);
  x_.resize(tile_count * kTilePixels);
  y_.resize(tile_count * kTilePixels);
  tiles_.resize(tile_count);
  constexpr float kHuge = std::numeric_limits<float>::max();
  row_rectangles_.assign(static_cast<std::size_t>(tile_rows_), {kHuge, -kHuge, kHuge, -kHuge});
  for (std::size_t k = 0; k < tile_count; ++k) {
    const int left = static_cast<int>(k) % tile_columns_ * kTileSize,
              top = static_cast<int>(k) / tile_columns_ * kTileSize;
    float* const x = x_.data() + k * kTilePixels;
    float* const y = y_.data() + k * kTilePixels;
    for (int i = 0; i < kTilePixels; ++i) {
      const int u = std::min(left + i % kTileSize, camera.width - 1),
                v = std::min(top + i / kTileSize, camera.height - 1);
      const RaySlopes ray = unproject(camera, {static_cast<double>(u), static_cast<double>(v)}, limit);
      x[i] = static_cast<float>(ray.x), y[i] = static_cast<float>(ray.y);
    }
    findRanges(x, y, tiles_[k]);
    const int middle = kTilePixels / 2 + kTileSize / 2;
    findPixelSize(camera, {x[middle], y[middle]}, tiles_[k]);
    SlopeRectangle& row = row_rectangles_[k / static_cast<std::size_t>(tile_columns_)];
    row.x_low = std::min(row.x_low, tiles_[k].x_low), row.x_high = std::max(row.x_high, tiles_[k].x_high);
    row.y_low = std::min(row.y_low, tiles_[k].y_low), row.y_high = std::max(row.y_high, tiles_[k].y_high);
  }
}

RaySlopes RayTable::ray(int u, int v) const {
  const int tile = v / kTileSize * tile_columns_ + u / kTileSize;
  const int place = tile * kTilePixels + v % kTileSize * kTileSize + u % kTileSize;
  return {x_[static_cast<std::size_t>(place)], y_[static_cast<std::size_t>(place)]};
}

}  // namespace murosimf
