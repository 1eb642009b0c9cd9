#pragma once

/// @file The ground and what is painted on it. A part of the ray caster's kernel.
///
/// A strip (carpet, painted line) is a rectangle of half sizes H across and l along. Its share of a pixel is a box
/// filter as wide as the pixel's footprint F, product of the two directions, with s the distance from its middle:
///   share = max(0, min(1, 2 H / F, (H - s) / F + 1/2)),  F^2 = (ds/du)^2 + (ds/dv)^2 per pixel u, v.
/// So a line keeps its area however far it is, and grows faint instead of flickering. All are taken times w: s w is a
/// linear form of slopes and ds/du w = (s w)_u - s w_u.
/// Strips that no pixel of a tile can show are dropped by the corners of the tile's rectangle of slopes: the ground is
/// a projective image of it, so what lies beyond a line for all corners lies beyond it for all pixels.

#include "murosimf/algorithms/cast_tile.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Corners of that part of a tile's rectangle of slopes in which something painted can be seen: 0 to 5 of them.
struct GroundPatch {
  static constexpr int kCornersAtMost = 5;
  float x[kCornersAtMost + 1], y[kCornersAtMost + 1], w[kCornersAtMost + 1];
  int corners;
  bool clipped;  ///< some of the rectangle lies farther than anything painted
  float reach;   ///< upper bound of half a footprint [m]
};

/// Corner a, and where the edge from a to b passes w_far.
inline void addCorner(const CastGround& ground, float ax, float ay, float bx, float by, GroundPatch& patch) {
  const float wa = evaluate(ground.w, ax, ay), wb = evaluate(ground.w, bx, by);
  const bool a_near = wa >= ground.w_far, b_near = wb >= ground.w_far;
  if (a_near) {
    patch.x[patch.corners] = ax, patch.y[patch.corners] = ay, patch.w[patch.corners] = wa;
    ++patch.corners;
  }
  if (!a_near) patch.clipped = true;
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
  patch.corners = 0, patch.clipped = false;
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

/// Adds a strip's share to a plane of the buffer.
template <class S>
inline void addStrip(const Tile& tile, const CastGround& g, int strip, bool sides, bool ends, float* plane) {
  const FormInTile ground = inTile(g.w, tile.rays);
  const FormInTile across = inTile({g.across_x[strip], g.across_y[strip], g.across_one[strip]}, tile.rays);
  const FormInTile along = inTile({g.along_x[strip], g.along_y[strip], g.along_one[strip]}, tile.rays);
  forPacks<S>(tile, [&](int i) {
    const auto painted = load<S>(tile.buffer.label + i) == S(kGround);
    if (laneBits(painted) == 0) return;
    const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), w = load<S>(tile.buffer.w + i);
    S cover(1.0F);
    if (sides) cover = share(across, ground, x, y, w, g.half_width[strip]);
    if (ends) cover = cover * share(along, ground, x, y, w, g.half_length[strip]);
    cover = select(w >= S(g.w_far), cover, S(0.0F));
    store(plane + i, load<S>(plane + i) + cover);
  });
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

template <class S>
inline void addRing(const Tile& tile, const CastGround& g, const CastRing& ring) {
  const FormInTile ground = inTile(g.w, tile.rays), rx = inTile(ring.x, tile.rays), ry = inTile(ring.y, tile.rays);
  forPacks<S>(tile, [&](int i) {
    const auto painted = load<S>(tile.buffer.label + i) == S(kGround);
    if (laneBits(painted) == 0) return;
    const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), w = load<S>(tile.buffer.w + i);
    const S px = evaluate(ring.x, x, y), py = evaluate(ring.y, x, y), z = S(1.0F) / w;
    const S radius = max(sqrt(px * px + py * py), S(1e-12F)), inverse = S(1.0F) / radius;
    const S mx = px * inverse, my = py * inverse;
    const S s_u = mx * (S(rx.u) - px * z * S(ground.u)) + my * (S(ry.u) - py * z * S(ground.u));
    const S s_v = mx * (S(rx.v) - px * z * S(ground.v)) + my * (S(ry.v) - py * z * S(ground.v));
    const S cover = share(radius - S(ring.radius) * w, s_u, s_v, S(ring.half_width) * w);
    float* const plane = tile.buffer.paint + i;
    store(plane, load<S>(plane) + select(w >= S(g.w_far), cover, S(0.0F)));
  });
}

/// Darkens the ground beneath drawables: light 1 - strength (1 - r^2)^2 within r < 1.
template <class S>
inline void addShadows(const Tile& tile) {
  const CastRow& row = tile.candidates;
  forCandidates<S>(tile, [&](int k) {
    const CastSurface& shadow = tile.scene.surfaces[row.surface[k]];
    if (shadow.kind != CastKind::kShadow) return;
    forPacksWithin<S>(tile, row.x_low[k], row.x_high[k], row.y_low[k], row.y_high[k], [&](int i) {
      TileBuffer& b = tile.buffer;
      const auto on_ground = load<S>(b.label + i) == S(kGround);
      if (laneBits(on_ground) == 0) return;
      const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), z = S(1.0F) / load<S>(b.w + i);
      const S dx = evaluate(shadow.offset[0], x, y) * z, dy = evaluate(shadow.offset[1], x, y) * z;
      const S inside = max(S(1.0F) - (dx * dx + dy * dy), S(0.0F));
      const S light = select(on_ground, S(1.0F) - S(shadow.strength) * (inside * inside), S(1.0F));
      store(b.red + i, load<S>(b.red + i) * light);
      store(b.green + i, load<S>(b.green + i) * light);
      store(b.blue + i, load<S>(b.blue + i) * light);
    });
  });
}

/// First pass: w and label of ground and sky, colours of the sky and of ground without paint.
template <class S>
inline void castPlane(const Tile& tile, const CastColour& ground_colour) {
  const CastColour &g = ground_colour, &sky = tile.scene.ground.sky;
  forPacks<S>(tile, [&](int i) {
    TileBuffer& b = tile.buffer;
    const S w = max(evaluate(tile.scene.ground.w, load<S>(tile.x + i), load<S>(tile.y + i)), S(0.0F));
    const auto ground = w > S(0.0F);
    store(b.w + i, w);
    store(b.red + i, select(ground, S(g.red), S(sky.red)));
    store(b.green + i, select(ground, S(g.green), S(sky.green)));
    store(b.blue + i, select(ground, S(g.blue), S(sky.blue)));
    store(b.label + i, select(ground, S(kGround), S(kSky)));
    if (tile.job.antialias) store(b.surface + i, select(ground, S(-1.0F), S(-2.0F)));
  });
}

/// Colours of ground with paint, from the two shares.
template <class S>
inline void mixPaint(const Tile& tile, const CastGround& g) {
  forPacks<S>(tile, [&](int i) {
    TileBuffer& b = tile.buffer;
    const auto ground = load<S>(b.label + i) == S(kGround);
    if (laneBits(ground) == 0) return;
    const S carpet = load<S>(b.carpet + i), paint = min(load<S>(b.paint + i), S(1.0F));
    const auto mix = [&](float* plane, float surroundings, float of_carpet, float of_paint) {
      const S base = S(surroundings) + (S(of_carpet) - S(surroundings)) * carpet;
      store(plane + i, select(ground, base + (S(of_paint) - base) * paint, load<S>(plane + i)));
    };
    mix(b.red, g.surroundings.red, g.carpet.red, g.paint.red);
    mix(b.green, g.surroundings.green, g.carpet.green, g.paint.green);
    mix(b.blue, g.surroundings.blue, g.carpet.blue, g.paint.blue);
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
      addStrip<S>(tile, g, first + lane, strips.sides >> lane & 1U, strips.ends >> lane & 1U, tile.buffer.paint);
    }
  }
  for (int k = 0; k < g.ring_count; ++k) {
    if (misses(g.rings[k], patch)) continue;
    prepare();
    addRing<S>(tile, g, g.rings[k]);
  }
  return painted;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
