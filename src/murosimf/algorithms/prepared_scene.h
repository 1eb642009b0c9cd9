#pragma once

/// @file A scene as one camera sees it, ready for casting: the work memory of one picture, to be used again for the
/// next.

#include <vector>

#include "murosimf/algorithms/cast_data.h"

namespace murosimf {

/// Filled by prepareScene(), read by castRows(). Nothing in it needs to be known by its owner; its vectors keep their
/// memory. Moved, not copied: `cast` points into the vectors.
struct PreparedScene {
  /// A surface's rectangle of slopes, nearest inverse depth and place in `surfaces`.
  struct Extent {
    float x_low, x_high, y_low, y_high, nearest;
    std::int32_t surface;
  };

  PreparedScene() = default;
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;
  PreparedScene(PreparedScene&&) = default;
  PreparedScene& operator=(PreparedScene&&) = default;

  CastScene cast{};
  std::vector<CastSurface> surfaces;
  std::vector<CastMeshView> meshes;
  std::vector<std::int32_t> part_of;  ///< number of the drawable of surface k at 2 + k, after those of sky and ground
  std::vector<Extent> extents;        ///< front to back
  std::vector<float> row_x_low, row_x_high, row_y_low, row_y_high;  ///< of all rows of tiles, one after the other
  std::vector<std::int32_t> row_surface;
  std::vector<CastRow> rows;
  std::vector<float> strips;  ///< the eight arrays of CastGround, one after the other
  std::vector<CastRing> rings;
  // What throws shadows, as the lamp sees it: its surfaces, their rectangles, all in one row.
  std::vector<CastScene> lamp_scene;  ///< one
  std::vector<CastSurface> casters;
  std::vector<CastMeshView> caster_meshes;
  std::vector<float> caster_x_low, caster_x_high, caster_y_low, caster_y_high;
  std::vector<std::int32_t> caster_surface;
  std::vector<CastRow> caster_row;  ///< one
};

}  // namespace murosimf
