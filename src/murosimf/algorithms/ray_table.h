#pragma once

/// @file The ray of every pixel, computed once for a camera model: this is why lens distortion costs nothing later.
///
/// Pixels are kept by tiles of 16 x 16, so that the ray caster reads memory in the order in which it works. Each tile
/// knows the smallest rectangle of slopes that holds its rays; objects are culled by rectangles in slopes, which is
/// correct for any lens.

#include <vector>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/algorithms/cast_data.h"
#include "murosimf/algorithms/slope_rectangle.h"

namespace murosimf {

class RayTable {
 public:
  /// @throws std::invalid_argument as checkCamera() does. Cost: some 80 ms for 640 x 480.
  explicit RayTable(const CameraModel& camera);

  const CameraModel& camera() const { return camera_; }
  int tileColumns() const { return tile_columns_; }
  int tileRows() const { return tile_rows_; }
  /// Slopes of the ray of a pixel; u in [0, width), v in [0, height).
  RaySlopes ray(int u, int v) const;

  /// [tile][row in tile][column in tile]. Pixels of a tile outside the picture repeat the ray of the nearest pixel.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const TileRays* tiles() const { return tiles_.data(); }  ///< row by row
  /// Rectangle of slopes of each row of tiles.
  const std::vector<SlopeRectangle>& rowRectangles() const { return row_rectangles_; }

 private:
  CameraModel camera_;
  int tile_columns_, tile_rows_;
  std::vector<float> x_, y_;
  std::vector<TileRays> tiles_;
  std::vector<SlopeRectangle> row_rectangles_;
};

}  // namespace murosimf
