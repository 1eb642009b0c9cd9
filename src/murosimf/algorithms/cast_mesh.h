#pragma once

/// @file Rays meet triangles. A part of the ray caster's kernel; formulas: cast_mesh_data.h.
///
/// The 256 rays of a tile go through the tree as one beam: boxes and triangles are put against its four sides, eight at
/// a time, and only what a triangle can reach is put against pixels. What all pixels of the tile have something in
/// front of is left out. A pixel takes a triangle only within the triangle's own rectangle and range of depths, so that
/// nothing depends on how pixels are packed. Neighbours share an edge's form up to its sign: no ray slips between them.

#include "murosimf/algorithms/cast_seen.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

using Eight = Pack<float, kMeshWidth>;
struct EightVectors {
  Eight x, y, z;
};

// Sums in this order, never fused: a turned sign turns the sign of the result and changes no digit.
inline Eight along(const float (&axis)[3], const EightVectors& v) {
  return (Eight(axis[0]) * v.x + Eight(axis[1]) * v.y) + Eight(axis[2]) * v.z;
}
inline Eight product(const EightVectors& a, const EightVectors& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
inline EightVectors difference(const EightVectors& a, const EightVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline EightVectors crossed(const EightVectors& a, const EightVectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The four sides of a tile's beam in the frame of a mesh: points with normal . p + offset < 0 lie outside.
struct BeamSides {
  float normal[4][3], offset[4];
};
inline BeamSides sidesOf(const Tile& tile, const CastMeshView& v) {
  const float limit[4] = {tile.rays.x_low - tile.margin_x, tile.rays.x_high + tile.margin_x,
                          tile.rays.y_low - tile.margin_y, tile.rays.y_high + tile.margin_y};
  BeamSides sides;
  for (int k = 0; k < 4; ++k) {
    const float sign = k % 2 == 0 ? 1.0F : -1.0F, tilt = v.perspective ? limit[k] : 0.0F;
    const float(&axis)[3] = v.row[k / 2];
    for (int i = 0; i < 3; ++i) sides.normal[k][i] = sign * (axis[i] - tilt * v.row[2][i]);
    const float at = v.perspective ? limit[k] * v.offset[2] : limit[k];
    sides.offset[k] = sign * (v.offset[k / 2] - at) + v.slack * (1.0F + abs(tilt));
  }
  return sides;
}

/// Largest and smallest of axis . p over a node's boxes.
inline Eight farthest(const CastMeshNode& node, const float (&axis)[3], bool backwards) {
  Eight sum(0.0F);
  for (int i = 0; i < 3; ++i) {
    const bool high = (axis[i] > 0.0F) != backwards;
    sum = sum + Eight(axis[i]) * load<Eight>(high ? node.high[i] : node.low[i]);
  }
  return sum;
}

/// Children that the beam may meet before w_behind, as bits.
inline unsigned childrenMet(const CastMeshNode& node, const BeamSides& sides, const CastMeshView& v, float w_behind) {
  auto met = Eight(0.0F) <= load<Eight>(node.high[0]) - load<Eight>(node.low[0]);
  for (int k = 0; k < 4; ++k)
    met = met & (farthest(node, sides.normal[k], false) + Eight(sides.offset[k]) >= Eight(0.0F));
  const Eight far = farthest(node, v.row[2], false) + Eight(v.offset[2] + v.slack);
  if (!v.perspective) return laneBits(met & (far > Eight(w_behind)));
  const Eight near = farthest(node, v.row[2], true) + Eight(v.offset[2] - v.slack);
  return laneBits(met & (far > Eight(0.0F)) & (near * Eight(w_behind) <= Eight(1.0F)));
}

/// Eight triangles as the beam meets them: what a pixel needs.
struct TrianglesMet {
  alignas(32) float edge[3][3][kMeshWidth], w[3][kMeshWidth];  ///< forms in xi, eta, 1
  alignas(32) float w_low[kMeshWidth], w_high[kMeshWidth], light[kMeshWidth];
  alignas(32) float x_low[kMeshWidth], x_high[kMeshWidth], y_low[kMeshWidth], y_high[kMeshWidth];
  unsigned met;
};

/// Rectangle and range of depths of each triangle.
inline void findRanges(const EightVectors (&u)[3], const CastMeshView& v, TrianglesMet& t) {
  constexpr float kNear = 1e-4F, kHuge = 3e38F;
  const Eight one(1.0F);
  Eight x_low(kHuge), x_high(-kHuge), y_low(kHuge), y_high(-kHuge), w_low(kHuge), w_high(-kHuge);
  auto behind = one < Eight(0.0F);
  for (int k = 0; k < 3; ++k) {
    const Eight height = along(v.row[2], u[k]) + Eight(v.offset[2]);
    const Eight inverse = one / max(height, Eight(kNear));
    const Eight scale = v.perspective ? inverse : one, w = v.perspective ? inverse : height;
    if (v.perspective) behind = behind | (height < Eight(kNear));
    const Eight x = (along(v.row[0], u[k]) + Eight(v.offset[0])) * scale;
    const Eight y = (along(v.row[1], u[k]) + Eight(v.offset[1])) * scale;
    x_low = min(x_low, x), x_high = max(x_high, x), y_low = min(y_low, y), y_high = max(y_high, y);
    w_low = min(w_low, w), w_high = max(w_high, w);
  }
  const Eight dx = Eight(2e-6F) * (one + max(abs(x_low), abs(x_high)));
  const Eight dy = Eight(2e-6F) * (one + max(abs(y_low), abs(y_high)));
  store(t.x_low, select(behind, Eight(-kHuge), x_low - dx)), store(t.x_high, select(behind, Eight(kHuge), x_high + dx));
  store(t.y_low, select(behind, Eight(-kHuge), y_low - dy)), store(t.y_high, select(behind, Eight(kHuge), y_high + dy));
  store(t.w_low, w_low), store(t.w_high, w_high);
}

inline EightVectors cornerOf(const CastTriangles& group, int corner) {
  return {load<Eight>(group.corner[corner][0]), load<Eight>(group.corner[corner][1]),
          load<Eight>(group.corner[corner][2])};
}

/// Light on each triangle: its normal turned towards the camera.
inline Eight lightOn(const CastScene& scene, const CastMeshView& v, const EightVectors& normal, Eight side) {
  const Eight cosine = Eight(v.facing) * side * along(v.lamp, normal) / sqrt(product(normal, normal));
  return Eight(scene.ambient) + Eight(1.0F - scene.ambient) * max(cosine, Eight(0.0F));
}

inline void meetGroup(const Tile& tile, const CastMeshView& v, const CastTriangles& group, float w_behind,
                      TrianglesMet& t) {
  const EightVectors u[3] = {cornerOf(group, 0), cornerOf(group, 1), cornerOf(group, 2)};
  findRanges(u, v, t);
  const auto met = (load<Eight>(t.x_low) <= Eight(tile.rays.x_high + tile.margin_x)) &
                   (load<Eight>(t.x_high) >= Eight(tile.rays.x_low - tile.margin_x)) &
                   (load<Eight>(t.y_low) <= Eight(tile.rays.y_high + tile.margin_y)) &
                   (load<Eight>(t.y_high) >= Eight(tile.rays.y_low - tile.margin_y)) &
                   (load<Eight>(t.w_high) > Eight(w_behind));
  t.met = laneBits(met);
  if (t.met == 0) return;
  const EightVectors normal = crossed(difference(u[1], u[0]), difference(u[2], u[0]));
  const Eight level = product(normal, u[0]);
  const Eight bottom = along(v.bottom, normal) + Eight(v.sink) * level;
  const Eight side = select(bottom < Eight(0.0F), Eight(-1.0F), Eight(1.0F));
  const Eight apart = v.mesh.closed ? bottom * Eight(v.facing) : abs(bottom);
  t.met = laneBits(met & (apart > Eight(1e-30F)));
  if (t.met == 0) return;
  const Eight inverse = Eight(1.0F) / bottom;
  for (int m = 0; m < 3; ++m) {
    const Eight top = along(v.top[m], normal);
    store(t.w[m], (m == 2 ? top + Eight(v.lift) * level : top) * inverse);
  }
  for (int k = 0; k < 3; ++k) {
    const EightVectors &from = u[(k + 1) % 3], &to = u[(k + 2) % 3];
    const EightVectors run = difference(to, from), area = crossed(from, to);
    for (int m = 0; m < 3; ++m) store(t.edge[k][m], side * (along(v.edge[m], run) + along(v.area[m], area)));
  }
  store(t.light, lightOn(tile.scene, v, normal, side));
}

/// Pixels of pack i that see triangle k.
template <class S, CastView kView>
inline void meetTriangle(const Tile& tile, const CastSurface& surface, const CastMeshView& v, const TrianglesMet& t,
                         int k, const CastColour& colour, int i) {
  const S x = load<S>(tile.x + i), y = load<S>(tile.y + i);
  const S xi = x - S(v.middle[0]), eta = y - S(v.middle[1]), zero(0.0F);
  auto inside = (x >= S(t.x_low[k])) & (x <= S(t.x_high[k])) & (y >= S(t.y_low[k])) & (y <= S(t.y_high[k]));
  for (const auto& edge : t.edge)
    inside = inside & ((S(edge[0][k]) * xi + S(edge[1][k]) * eta) + S(edge[2][k]) >= zero);
  const S flat = (S(t.w[0][k]) * xi + S(t.w[1][k]) * eta) + S(t.w[2][k]);
  const S w = clamp(flat, S(t.w_low[k]), S(t.w_high[k]));
  const auto nearest = inside & (w > load<S>(tile.buffer.w + i));
  if (laneBits(nearest) == 0) return;
  see<S, kView>(tile, i, nearest, w, lit(colour, S(t.light[k])), surface);
}

/// The farthest thing that the beam shows within a rectangle: its inverse depth.
template <class S>
inline float leastDepth(const Tile& tile, float x_low, float x_high, float y_low, float y_high) {
  S least(3e38F);
  forPacksWithin<S>(tile, x_low, x_high, y_low, y_high, [&](int i) { least = min(least, load<S>(tile.buffer.w + i)); });
  float lane[Lanes<S>::kWidth], found = 3e38F;
  store(lane, least);
  for (const float w : lane) found = min(found, w);
  return found;
}

template <class S, CastView kView>
inline void castMesh(const Tile& tile, const CastSurface& surface, float x_low, float x_high, float y_low,
                     float y_high) {
  const CastMeshView& v = tile.scene.meshes[surface.mesh];
  const BeamSides sides = sidesOf(tile, v);
  const float w_behind = leastDepth<S>(tile, x_low, x_high, y_low, y_high);
  std::int32_t waiting[kMeshStack];
  int count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::int32_t next = waiting[--count];
    if (next >= 0) {
      const CastMeshNode& node = v.mesh.nodes[next];
      for (unsigned met = childrenMet(node, sides, v, w_behind); met != 0; met &= met - 1)
        waiting[count++] = node.child[__builtin_ctz(met)];
      continue;
    }
    TrianglesMet t;
    meetGroup(tile, v, v.mesh.groups[~next], w_behind, t);
    for (unsigned met = t.met; met != 0; met &= met - 1) {
      const int k = __builtin_ctz(met);
      const CastColour& colour = v.mesh.colours ? v.mesh.colours[kMeshWidth * ~next + k] : surface.colour;
      forPacksWithin<S>(tile, t.x_low[k], t.x_high[k], t.y_low[k], t.y_high[k],
                        [&](int i) { meetTriangle<S, kView>(tile, surface, v, t, k, colour, i); });
    }
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
