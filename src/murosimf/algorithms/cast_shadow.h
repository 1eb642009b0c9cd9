#pragma once

/// @file Hard shadows: what stands between a point and the lamp. A part of the ray caster's kernel.
///
/// The points that a tile's pixels see are looked at from the lamp, whose rays are parallel: there a point has a place
/// (x, y) and a height, and lies in the shadow where some surface over that place is higher. That is the question that
/// the camera asks, with heights for inverse depths, so the same kernels answer it (lamp_preparation.cpp).

#include "murosimf/algorithms/cast_surfaces.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

inline constexpr float kShadowGap = 2e-3F;    ///< what lies higher by less throws no shadow: the surface itself [m]
inline constexpr float kShadowDepth = 60.0F;  ///< beyond, nothing is in a shadow [m]

/// Ranges of a tile's places as the lamp sees them, of pixels that may lie in a shadow.
struct LampRays {
  TileRays rays;
  unsigned rows = 0;
};

/// Light falls on these lanes of pack i and might be taken away.
template <class S>
inline auto isLit(const Tile& tile, int i) {
  const S w = load<S>(tile.buffer.w + i);
  return (w > S(1.0F / kShadowDepth)) & (load<S>(tile.buffer.light + i) > S(tile.scene.ambient));
}

/// Least and largest of all lanes.
template <class S>
inline void includeLanes(S least, S most, float& low, float& high) {
  float lanes[2][Lanes<S>::kWidth];
  store(lanes[0], least), store(lanes[1], most);
  for (const float value : lanes[0]) low = min(low, value);
  for (const float value : lanes[1]) high = max(high, value);
}

/// Fills places and heights of the tile's points into `lamp`.
template <class S>
inline LampRays placePoints(const Tile& tile, TileBuffer& lamp) {
  constexpr float kHuge = 3e38F;
  LampRays found;
  TileRays& r = found.rays;
  r.x_low = r.y_low = kHuge, r.x_high = r.y_high = -kHuge;
  for (int half = 0; half < 2; ++half) r.column_low[half] = kHuge, r.column_high[half] = -kHuge;
  for (int row = 0; row < kTileSize; ++row) r.row_low[row] = kHuge, r.row_high[row] = -kHuge;
  forPacks<S>(tile, [&](int i) {
    const auto wanted = isLit<S>(tile, i);
    if (laneBits(wanted) == 0) return store(lamp.w + i, S(kInShadow));
    const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), z = S(1.0F) / load<S>(tile.buffer.w + i);
    const LinearForm* place = tile.scene.lamp_place;
    const S a = evaluate(place[0], x, y) * z, b = evaluate(place[1], x, y) * z;
    const S gap = S(kShadowGap) + S(3e-5F) * z;
    store(lamp.x + i, a), store(lamp.y + i, b);
    store(lamp.w + i, select(wanted, evaluate(place[2], x, y) * z + gap, S(kInShadow)));
    const int row = i / kTileSize, column = i % kTileSize;
    includeLanes(select(wanted, b, S(kHuge)), select(wanted, b, S(-kHuge)), r.row_low[row], r.row_high[row]);
    float low = kHuge, high = -kHuge;
    includeLanes(select(wanted, a, S(kHuge)), select(wanted, a, S(-kHuge)), low, high);
    for (int half = 0; half < 2; ++half) {
      if (Lanes<S>::kWidth < kTileSize && column / (kTileSize / 2) != half) continue;
      r.column_low[half] = min(r.column_low[half], low), r.column_high[half] = max(r.column_high[half], high);
    }
    found.rows |= 1U << row;
  });
  for (int row = 0; row < kTileSize; ++row)
    r.y_low = min(r.y_low, r.row_low[row]), r.y_high = max(r.y_high, r.row_high[row]);
  r.x_low = min(r.column_low[0], r.column_low[1]), r.x_high = max(r.column_high[0], r.column_high[1]);
  return found;
}

/// Takes the lamp's light from what lies in a shadow.
template <class S>
inline void castShadows(const Tile& tile) {
  TileBuffer lamp;
  const LampRays points = placePoints<S>(tile, lamp);
  if (points.rows == 0) return;
  const CastScene& scene = *tile.scene.lamp_scene;
  const Tile from_lamp{tile.job, scene, *scene.rows, points.rays, lamp.x, lamp.y, 0.0F, 0.0F, points.rows, lamp};
  castSurfaces<S, CastView::kLamp>(from_lamp);
  forPacks<S>(from_lamp, [&](int i) {
    const auto dark = isLit<S>(tile, i) & (load<S>(lamp.w + i) == S(kInShadow));
    if (laneBits(dark) == 0) return;
    TileBuffer& b = tile.buffer;
    const S left = select(dark, S(tile.scene.ambient) / load<S>(b.light + i), S(1.0F));
    store(b.red + i, load<S>(b.red + i) * left);
    store(b.green + i, load<S>(b.green + i) * left);
    store(b.blue + i, load<S>(b.blue + i) * left);
    if (tile.job.antialias) store(b.surface + i, load<S>(b.surface + i) + select(dark, S(0.25F), S(0.0F)));
  });
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
