#pragma once

/// @file Ground, sky, shadows. A part of the ray caster's kernel.

#include "murosimf/algorithms/cast_texture.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

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
    if (tile.scene.lamp_scene) store(b.light + i, S(tile.scene.ground.light));
    if (keepsSurfaces(tile)) store(b.surface + i, select(ground, S(-1.0F), S(-2.0F)));
  });
}

/// Colours of ground with paint, from the carpet's and the two shares.
template <class S>
inline void mixPaint(const Tile& tile, const CastGround& g) {
  forPacks<S>(tile, [&](int i) {
    TileBuffer& b = tile.buffer;
    const auto ground = load<S>(b.label + i) == S(kGround);
    if (laneBits(ground) == 0) return;
    const S carpet = load<S>(b.carpet + i), paint = min(load<S>(b.paint + i), S(1.0F));
    const auto mix = [&](float* plane, float surroundings, float of_paint) {
      const S before = load<S>(plane + i), base = S(surroundings) + (before - S(surroundings)) * carpet;
      store(plane + i, select(ground, base + (S(of_paint) - base) * paint, before));
    };
    mix(b.red, g.surroundings.red, g.paint.red);
    mix(b.green, g.surroundings.green, g.paint.green);
    mix(b.blue, g.surroundings.blue, g.paint.blue);
  });
}

/// Gives ground that is painted by half or more a label of its own.
template <class S>
inline void markLines(const Tile& tile) {
  forPacks<S>(tile, [&](int i) {
    const S label = load<S>(tile.buffer.label + i);
    const auto line = (label == S(kGround)) & (load<S>(tile.buffer.paint + i) >= S(0.5F));
    store(tile.buffer.label + i, select(line, S(kLine), label));
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

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
