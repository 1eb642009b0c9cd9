#pragma once

/// @file The picture on the carpet. A part of the ray caster's kernel.
///
/// A texel's place is linear in the ground's, so (place w) and its change per pixel are forms of slopes as those of
/// painted lines are. The level is told by the footprint's longer side F [texels]: level = log2 F, taken between two
/// levels, four texels each. log2 is read from the number's own bits, exact at powers of two and 0.09 off at most.

#include "murosimf/algorithms/cast_paint.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S>
struct TexelPlace {
  S u, v, level;  ///< place in texels of level 0, from 0 on; level within what there is
};

template <class S>
inline TexelPlace<S> placeOfTexel(const CastGround& g, const FormInTile& u, const FormInTile& v,
                                  const FormInTile& ground, S x, S y, S w) {
  const S z = S(1.0F) / w, limit(1e6F), zero(0.0F);
  const S at_u = evaluate(u.form, x, y) * z, at_v = evaluate(v.form, x, y) * z;
  const S uu = (S(u.u) - at_u * S(ground.u)) * z, uv = (S(u.v) - at_u * S(ground.v)) * z;
  const S vu = (S(v.u) - at_v * S(ground.u)) * z, vv = (S(v.v) - at_v * S(ground.v)) * z;
  const S longer = clamp(max(uu * uu + vu * vu, uv * uv + vv * vv), S(1.0F), S(1e12F));
  const S level = S(0.5F) * (toNumber(bitsOf(longer)) * S(1.0F / 8388608.0F) - S(127.0F));
  return {clamp(at_u, zero, limit), clamp(at_v, zero, limit),
          min(max(level, zero), S(static_cast<float>(g.texture.levels - 1)))};
}

/// Four texels of one level, weighed by place: bytes from 0 to 255.
template <class S>
inline void readLevel(const CastTexture& t, const TexelPlace<S>& at, WordsOf<S> level, S (&colour)[3]) {
  const WordsOf<S> one = toWords(S(1.0F)), last = toWords(S(static_cast<float>(t.levels - 1))) - level;
  const S shrink = numberOfBits<S>((toWords(S(127.0F)) - level) << 23);
  // One side is added before the half texel is taken off, so that nothing is cut off towards 0 from below.
  const S side = numberOfBits<S>((toWords(S(127.0F)) + last) << 23);
  const S u = at.u * shrink + (side - S(0.5F)), v = at.v * shrink + (side - S(0.5F));
  const WordsOf<S> column = toWords(u), row = toWords(v), mask = (one << last) - one, first = gather<S>(t.first, level);
  const S right = u - toNumber(column), down = v - toNumber(row);
  const WordsOf<S> c0 = column & mask, c1 = (column + one) & mask;
  const WordsOf<S> r0 = first + ((row & mask) << last), r1 = first + (((row + one) & mask) << last);
  const WordsOf<S> texel[4] = {gather<S>(t.texels, r0 + c0), gather<S>(t.texels, r0 + c1), gather<S>(t.texels, r1 + c0),
                               gather<S>(t.texels, r1 + c1)};
  const WordsOf<S> byte = toWords(S(255.0F));
  for (int k = 0; k < 3; ++k) {
    S c[4];
    for (int i = 0; i < 4; ++i) c[i] = toNumber((texel[i] >> (8 * k)) & byte);
    const S top = c[0] + (c[1] - c[0]) * right, bottom = c[2] + (c[3] - c[2]) * right;
    colour[k] = top + (bottom - top) * down;
  }
}

/// Overwrites the colour of ground on which the carpet may lie.
template <class S>
inline void addTexture(const Tile& tile, const CastGround& g) {
  const FormInTile ground = inTile(g.w, tile.rays), u = inTile(g.texel_u, tile.rays), v = inTile(g.texel_v, tile.rays);
  const S share(g.texture_light / 255.0F);
  forPacks<S>(tile, [&](int i) {
    TileBuffer& b = tile.buffer;
    const S w = load<S>(b.w + i);
    const auto seen = (load<S>(b.label + i) == S(kGround)) & (w >= S(g.w_far));
    if (laneBits(seen) == 0) return;
    const S near = select(seen, w, S(g.w_far));
    const TexelPlace<S> at = placeOfTexel(g, u, v, ground, load<S>(tile.x + i), load<S>(tile.y + i), near);
    const WordsOf<S> fine = toWords(at.level);
    const WordsOf<S> coarse = toWords(min(toNumber(fine) + S(1.0F), S(static_cast<float>(g.texture.levels - 1))));
    const S between = at.level - toNumber(fine);
    S first[3], second[3];
    readLevel(g.texture, at, fine, first);
    readLevel(g.texture, at, coarse, second);
    float* const plane[3] = {b.red + i, b.green + i, b.blue + i};
    for (int k = 0; k < 3; ++k) {
      const S c = (first[k] + (second[k] - first[k]) * between) * share;
      store(plane[k], select(seen, c, load<S>(plane[k])));
    }
  });
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
