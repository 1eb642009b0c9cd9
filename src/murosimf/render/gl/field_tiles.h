#pragma once

/// @file Which parts of a picture show sky, bare ground, or ground on which there is more to tell: decided by tiles of
/// 16 x 16 pixels, so that only the last kind pays for lines.
///
/// A tile's rays lie in a rectangle of slopes (ray_table.h). Inverse depth is linear in slopes, so its ends are at the
/// rectangle's corners, and so are those of the place on the ground where all of the tile lies before the horizon. A
/// table of sums over the field's cells tells whether any of a rectangle of cells is marked.

#include <array>
#include <vector>

#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/algorithms/ray_table.h"

namespace murosimf {

/// Squares of the ground on which something is painted.
struct MarkedCells {
  double low_x = 0, low_y = 0, edge = 1;  ///< [m]
  int columns = 0, rows = 0;
  std::vector<int> sums;  ///< of marked cells below and left of a corner: (columns + 1) (rows + 1), row by row

  bool anyWithin(double x_low, double x_high, double y_low, double y_high) const;
};

/// A corner of a tile as OpenGL takes it: place from -1 to 1, row 0 first; 1 on the carpet, 0 beside it.
struct TileVertex {
  float x = 0, y = 0, carpet = 0;
};

/// Two triangles a run of tiles of a row. What is in neither list is sky.
struct FieldTiles {
  std::vector<TileVertex> bare, painted;
};

/// Overwrites tiles. marked: of this ground.
void sortTiles(const RayTable& rays, const PaintedGround& ground, const MarkedCells& marked, const Pose& X_WC,
               FieldTiles& tiles);

}  // namespace murosimf
