#pragma once

/// @file Which paint a tile can show at all. A part of the ray caster's kernel.
///
/// The ground is a projective image of a tile's rectangle of slopes: what lies beyond a line for all corners of the
/// rectangle lies beyond it for all pixels. Corners are those of the part in which paint can be seen; bounds are wider
/// than exact by half a footprint and a little, so that dropping a strip changes no pixel.

#include "murosimf/algorithms/cast_tile.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Corners of that part of a tile's rectangle of slopes in which something painted can be seen: 0 to 5 of them.
struct GroundPatch {
  static constexpr int kCornersAtMost = 5;
  float x[kCornersAtMost + 1], y[kCornersAtMost + 1], w[kCornersAtMost + 1];
  int corners;
  float reach;  ///< upper bound of half a footprint [m]
};

/// Corner a, and where the edge from a to b passes w_far.
inline void addCorner(const CastGround& ground, float ax, float ay, float bx, float by, GroundPatch& patch) {
  const float wa = evaluate(ground.w, ax, ay), wb = evaluate(ground.w, bx, by);
  const bool a_near = wa >= ground.w_far, b_near = wb >= ground.w_far;
  if (a_near) {
    patch.x[patch.corners] = ax, patch.y[patch.corners] = ay, patch.w[patch.corners] = wa;
    ++patch.corners;
  }
  if (a_near == b_near) return;
  const float share = (wa - ground.w_far) / (wa - wb);
  patch.x[patch.corners] = ax + share * (bx - ax), patch.y[patch.corners] = ay + share * (by - ay);
  patch.w[patch.corners] = ground.w_far;
  ++patch.corners;
}

inline GroundPatch findPatch(const Tile& tile) {
  const TileRays& rays = tile.rays;
  const CastGround& ground = tile.scene.ground;
  GroundPatch patch;
  patch.corners = 0;
  const float u = abs(rays.x_u) + abs(rays.y_u), v = abs(rays.x_v) + abs(rays.y_v);
  const float left = rays.x_low - 0.5F * u, right = rays.x_high + 0.5F * u;  // room for four samples a pixel
  const float top = rays.y_low - 0.5F * v, bottom = rays.y_high + 0.5F * v;
  addCorner(ground, left, top, right, top, patch);
  addCorner(ground, right, top, right, bottom, patch);
  addCorner(ground, right, bottom, left, bottom, patch);
  addCorner(ground, left, bottom, left, top, patch);
  float z_most = 0, offset_most = 0;  // |dX/du| <= z |d slope/du| (1 + |X - c| / height)
  for (int k = 0; k < patch.corners; ++k) {
    const float z = 1.0F / patch.w[k];
    const float x = z * evaluate(ground.x, patch.x[k], patch.y[k]), y = z * evaluate(ground.y, patch.x[k], patch.y[k]);
    z_most = max(z_most, z);
    offset_most = max(offset_most, sqrt(x * x + y * y));
  }
  patch.reach = 0.01F + 0.55F * z_most * sqrt(u * u + v * v) * (1.0F + offset_most / ground.height);
  return patch;
}

/// Which of a pack of strips may show in a patch; of these, whose sides, whose ends may; as bits.
struct StripsInPatch {
  unsigned shown, sides, ends;
};

template <class S>
inline StripsInPatch findStrips(const CastGround& ground, const GroundPatch& patch, int first) {
  const S half_width = load<S>(ground.half_width + first), half_length = load<S>(ground.half_length + first);
  const S reach(patch.reach);
  const S wide = half_width + reach, narrow = half_width - reach, far = half_length + reach, near = half_length - reach;
  auto left = reach == reach, right = left, before = left, behind = left, within_sides = left, within_ends = left;
  for (int k = 0; k < patch.corners; ++k) {
    const S x(patch.x[k]), y(patch.y[k]), w(patch.w[k]);
    const S across = (load<S>(ground.across_x + first) * x + load<S>(ground.across_y + first) * y) +
                     load<S>(ground.across_one + first);
    const S along =
        (load<S>(ground.along_x + first) * x + load<S>(ground.along_y + first) * y) + load<S>(ground.along_one + first);
    left = left & (across > wide * w), right = right & (across < -(wide * w));
    before = before & (along < -(far * w)), behind = behind & (along > far * w);
    within_sides = within_sides & (abs(across) < narrow * w);
    within_ends = within_ends & (abs(along) < near * w);
  }
  const int count = ground.strip_count - first;
  const unsigned present = count >= Lanes<S>::kWidth ? ~0U : (1U << count) - 1U;
  return {laneBits(!(left | right | before | behind)) & present, laneBits(!within_sides), laneBits(!within_ends)};
}

/// True where a ring cannot show in a patch: all of it nearer to the centre, or all farther away.
inline bool misses(const CastRing& ring, const GroundPatch& patch) {
  float sum_x = 0, sum_y = 0, farthest = 0;
  float px[GroundPatch::kCornersAtMost + 1], py[GroundPatch::kCornersAtMost + 1];
  for (int k = 0; k < patch.corners; ++k) {
    px[k] = evaluate(ring.x, patch.x[k], patch.y[k]) / patch.w[k];
    py[k] = evaluate(ring.y, patch.x[k], patch.y[k]) / patch.w[k];
    sum_x += px[k], sum_y += py[k];
    farthest = max(farthest, sqrt(px[k] * px[k] + py[k] * py[k]));
  }
  const float x = sum_x / static_cast<float>(patch.corners), y = sum_y / static_cast<float>(patch.corners);
  float size = 0;
  for (int k = 0; k < patch.corners; ++k) size = max(size, sqrt((px[k] - x) * (px[k] - x) + (py[k] - y) * (py[k] - y)));
  const float nearest = sqrt(x * x + y * y) - size, reach = ring.half_width + patch.reach;
  return farthest < ring.radius - reach || nearest > ring.radius + reach;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
