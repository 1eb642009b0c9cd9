#pragma once

/// @file How much of a pixel is painted. A part of the ray caster's kernel.
///
/// A strip (carpet, painted line) is a rectangle of half sizes H across and l along. Its share of a pixel is a box
/// filter as wide as the pixel's footprint F, product of the two directions, with s the distance from its middle:
///   share = max(0, min(1, 2 H / F, (H - s) / F + 1/2)),  F^2 = (ds/du)^2 + (ds/dv)^2 per pixel u, v.
/// So a line keeps its area however far it is, and grows faint instead of flickering. All are taken times w: s w is a
/// linear form of slopes and ds/du w = (s w)_u - s w_u. Shares of several strips are added and cut at 1.

#include "murosimf/algorithms/cast_patch.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Box filter: distance s from the middle, times w; its change per pixel, times w; half size, times w.
template <class S>
inline S share(S s, S s_u, S s_v, S half) {
  const S inverse = S(1.0F) / sqrt(s_u * s_u + s_v * s_v);
  const S at_edge = (half - abs(s)) * inverse + S(0.5F);
  const S at_most = min(S(1.0F), (half + half) * inverse);
  return max(min(at_most, at_edge), S(0.0F));
}

/// A form and its change from pixel to pixel of this tile.
struct FormInTile {
  LinearForm form;
  float u, v;
};
inline FormInTile inTile(const LinearForm& form, const TileRays& rays) {
  return {form, form.x * rays.x_u + form.y * rays.y_u, form.x * rays.x_v + form.y * rays.y_v};
}
/// Share of a pixel, of a footprint at distance form / w from a middle.
template <class S>
inline S share(const FormInTile& form, const FormInTile& ground, S x, S y, S w, float half_size) {
  const S s = evaluate(form.form, x, y);
  const S metres = s / w;
  return share(s, S(form.u) - metres * S(ground.u), S(form.v) - metres * S(ground.v), S(half_size) * w);
}

/// True where no lane has a share: all lie farther from the middle than half the size and half a footprint.
template <class S>
inline bool isBeside(S s, float half_size, float reach, S w) {
  return laneBits(abs(s) <= S(half_size + reach) * w) == 0;
}

/// Adds a strip's share to a plane of the buffer. reach: that of the tile's patch.
template <class S>
inline void addStrip(const Tile& tile, const CastGround& g, int strip, bool sides, bool ends, float reach,
                     float* plane) {
  const FormInTile ground = inTile(g.w, tile.rays);
  const FormInTile across = inTile({g.across_x[strip], g.across_y[strip], g.across_one[strip]}, tile.rays);
  const FormInTile along = inTile({g.along_x[strip], g.along_y[strip], g.along_one[strip]}, tile.rays);
  forPacks<S>(tile, [&](int i) {
    const auto painted = load<S>(tile.buffer.label + i) == S(kGround);
    if (laneBits(painted) == 0) return;
    const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), w = load<S>(tile.buffer.w + i);
    if (sides && isBeside(evaluate(across.form, x, y), g.half_width[strip], reach, w)) return;
    if (ends && isBeside(evaluate(along.form, x, y), g.half_length[strip], reach, w)) return;
    S cover(1.0F);
    if (sides) cover = share(across, ground, x, y, w, g.half_width[strip]);
    if (ends) cover = cover * share(along, ground, x, y, w, g.half_length[strip]);
    cover = select(w >= S(g.w_far), cover, S(0.0F));
    store(plane + i, load<S>(plane + i) + cover);
  });
}

template <class S>
inline void addRing(const Tile& tile, const CastGround& g, const CastRing& ring, float reach) {
  const FormInTile ground = inTile(g.w, tile.rays), rx = inTile(ring.x, tile.rays), ry = inTile(ring.y, tile.rays);
  forPacks<S>(tile, [&](int i) {
    const auto painted = load<S>(tile.buffer.label + i) == S(kGround);
    if (laneBits(painted) == 0) return;
    const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), w = load<S>(tile.buffer.w + i);
    const S px = evaluate(ring.x, x, y), py = evaluate(ring.y, x, y);
    const S radius = max(sqrt(px * px + py * py), S(1e-12F));
    if (isBeside(radius - S(ring.radius) * w, ring.half_width, reach, w)) return;
    const S z = S(1.0F) / w, inverse = S(1.0F) / radius;
    const S mx = px * inverse, my = py * inverse;
    const S s_u = mx * (S(rx.u) - px * z * S(ground.u)) + my * (S(ry.u) - py * z * S(ground.u));
    const S s_v = mx * (S(rx.v) - px * z * S(ground.v)) + my * (S(ry.v) - py * z * S(ground.v));
    const S cover = share(radius - S(ring.radius) * w, s_u, s_v, S(ring.half_width) * w);
    float* const plane = tile.buffer.paint + i;
    store(plane, load<S>(plane) + select(w >= S(g.w_far), cover, S(0.0F)));
  });
}

template <class S>
inline void fillPlane(const Tile& tile, float* plane, float value) {
  forPacks<S>(tile, [&](int i) { store(plane + i, S(value)); });
}

/// All strips and rings that show; false when none does, and the planes are then as before.
template <class S>
inline bool addPaint(const Tile& tile, const GroundPatch& patch) {
  const CastGround& g = tile.scene.ground;
  bool painted = false;
  const auto prepare = [&] {
    if (!painted) fillPlane<S>(tile, tile.buffer.paint, 0.0F);
    painted = true;
  };
  for (int first = 0; first < g.strip_count; first += Lanes<S>::kWidth) {
    const StripsInPatch strips = findStrips<S>(g, patch, first);
    for (unsigned left = strips.shown; left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      if (first + lane == 0) continue;  // the carpet
      prepare();
      addStrip<S>(tile, g, first + lane, strips.sides >> lane & 1U, strips.ends >> lane & 1U, patch.reach,
                  tile.buffer.paint);
    }
  }
  for (int k = 0; k < g.ring_count; ++k) {
    if (misses(g.rings[k], patch)) continue;
    prepare();
    addRing<S>(tile, g, g.rings[k], patch.reach);
  }
  return painted;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
