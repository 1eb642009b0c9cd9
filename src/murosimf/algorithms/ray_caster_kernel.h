#pragma once

/// @file The ray caster's kernel: all tiles of a band of rows, S = float or a pack of float.
///
/// A tile is made in passes over its pixels: ground and sky, solid surfaces front to back, paint where the ground is
/// still seen, shadows, bytes. Four samples a pixel go through all passes but the last once more. Include in
/// ray_caster.cpp and in the files of one instruction set only.

#include "murosimf/algorithms/cast_ground.h"
#include "murosimf/algorithms/cast_shadow.h"
#include "murosimf/algorithms/cast_store.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Passes but the last, for one ray a pixel.
template <class S>
inline void castSample(const Tile& tile, const GroundPatch& patch) {
  const CastGround& g = tile.scene.ground;
  StripsInPatch carpet{0, 0, 0};
  if (patch.corners > 0) carpet = findStrips<S>(g, patch, 0);
  const bool some_carpet = (carpet.shown & 1U) != 0;
  const bool carpet_ends = some_carpet && ((carpet.sides | carpet.ends) & 1U) != 0;
  castPlane<S>(tile, some_carpet ? g.carpet : g.surroundings);
  castSurfaces<S, CastView::kCamera>(tile);
  if (some_carpet && g.texture.levels > 0) addTexture<S>(tile, g);
  const bool painted = patch.corners > 0 && addPaint<S>(tile, patch);
  if (painted || carpet_ends) {
    fillPlane<S>(tile, tile.buffer.carpet, some_carpet && !carpet_ends ? 1.0F : 0.0F);
    if (carpet_ends) addStrip<S>(tile, g, 0, carpet.sides & 1U, carpet.ends & 1U, patch.reach, tile.buffer.carpet);
    if (!painted) fillPlane<S>(tile, tile.buffer.paint, 0.0F);
    mixPaint<S>(tile, g);
  }
  if (tile.scene.has_shadows) addShadows<S>(tile);
  if (tile.scene.lamp_scene) castShadows<S>(tile);
  if (painted && tile.job.marks_lines) markLines<S>(tile);
}

/// Rows in which, or in whose neighbours, more than one thing is seen; as bits.
inline unsigned findMixedRows(const TileBuffer& b) {
  unsigned mixed = 0;
  for (int row = 0; row < kTileSize; ++row) {
    const int first = (row > 0 ? row - 1 : row) * kTileSize,
              last = (row + 2 < kTileSize ? row + 2 : kTileSize) * kTileSize;
    bool same = true;
    for (int i = first; i < last; ++i) same = same & (b.surface[i] == b.surface[first]);
    if (!same) mixed |= 1U << row;
  }
  return mixed;
}

/// Replaces the colours of mixed rows by the mean of four rays a pixel, at the places of a turned square.
template <class S>
inline void antialias(const Tile& tile, const GroundPatch& patch) {
  constexpr float kOffset[4][2] = {{0.125F, 0.375F}, {-0.375F, 0.125F}, {-0.125F, -0.375F}, {0.375F, -0.125F}};
  const unsigned rows = findMixedRows(tile.buffer);
  if (rows == 0) return;
  const TileRays& r = tile.rays;
  TileBuffer sample;
  const Tile part{tile.job,
                  tile.scene,
                  tile.candidates,
                  r,
                  sample.x,
                  sample.y,
                  0.5F * (abs(r.x_u) + abs(r.x_v)),
                  0.5F * (abs(r.y_u) + abs(r.y_v)),
                  rows,
                  sample};
  TileBuffer& sum = tile.buffer;
  for (int k = 0; k < 4; ++k) {
    const S dx(kOffset[k][0] * r.x_u + kOffset[k][1] * r.x_v), dy(kOffset[k][0] * r.y_u + kOffset[k][1] * r.y_v);
    forPacks<S>(part, [&](int i) {
      store(sample.x + i, load<S>(tile.x + i) + dx);
      store(sample.y + i, load<S>(tile.y + i) + dy);
    });
    castSample<S>(part, patch);
    const auto add = [&](float* plane, const float* more, int i) {
      const S before = k == 0 ? S(0.0F) : load<S>(plane + i);
      store(plane + i, before + S(0.25F) * load<S>(more + i));
    };
    forPacks<S>(part, [&](int i) {
      add(sum.red, sample.red, i);
      add(sum.green, sample.green, i);
      add(sum.blue, sample.blue, i);
    });
  }
}

template <class S>
inline void castTiles(const CastJob& job) {
  TileBuffer buffer;
  for (int tile_row = job.first_row / kTileSize; tile_row * kTileSize < job.last_row; ++tile_row) {
    for (int column = 0; column < job.tile_columns; ++column) {
      const int index = tile_row * job.tile_columns + column;
      const CastScene& scene = *job.scene;
      const Tile tile{job,
                      scene,
                      scene.rows[tile_row],
                      job.tiles[index],
                      job.x + index * kTilePixels,
                      job.y + index * kTilePixels,
                      0.0F,
                      0.0F,
                      kAllRows,
                      buffer};
      const GroundPatch patch = findPatch(tile);
      castSample<S>(tile, patch);
      if (job.antialias) antialias<S>(tile, patch);
      storeTile<S>(job, buffer, column * kTileSize, tile_row * kTileSize);
    }
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
