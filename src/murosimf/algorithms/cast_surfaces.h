#pragma once

/// @file Rays meet boxes, ellipsoids, cylinders and capsules. A part of the ray caster's kernel.
///
/// Formulas (o: camera's place, d: ray's direction, both in the surface's own frame, where it has half sizes 1):
///   plane      s = o_i + t d_i                    w = d_i / (s - o_i)
///   ellipsoid  1 = |o + t d|^2,  c = o.o - 1      w = (sqrt(d.d - |o x d|^2) - o.d) / c     [Lagrange's identity keeps
///   cylinder   the same in two dimensions         the digits that (o.d)^2 - c d.d loses for far surfaces]
/// The coefficients in x and y are made once a picture, in double (scene_preparation.h).

#include "murosimf/algorithms/cast_mesh.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Half sizes are measured times w by a camera, as they are by the lamp; and what is seen where nothing is.
template <class S, CastView kView>
inline S unitAt(S w) {
  return kView == CastView::kCamera ? w : S(1.0F);
}
template <class S, CastView kView>
inline S nothingYet() {
  return S(kView == CastView::kCamera ? 0.0F : -kInShadow);
}

/// A box of which kFronts planes face the camera: entered behind all of these, left at the first of the others.
template <class S, CastView kView, int kFronts>
inline void meetBox(const Tile& tile, const CastSurface& box, int i) {
  const S x = load<S>(tile.x + i), y = load<S>(tile.y + i);
  S entry = evaluate(box.plane[0], x, y), second = entry, third = entry;
  if constexpr (kFronts > 1) second = evaluate(box.plane[1], x, y), entry = min(entry, second);
  if constexpr (kFronts > 2) third = evaluate(box.plane[2], x, y), entry = min(entry, third);
  S exit = evaluate(box.plane[kFronts], x, y);
  for (int k = kFronts + 1; k < 6; ++k) exit = max(exit, evaluate(box.plane[k], x, y));
  const auto nearest = (entry >= exit) & (entry > load<S>(tile.buffer.w + i));
  if (laneBits(nearest) == 0) return;
  const CastColour* c = box.plane_colour;
  Lit<S> colour{S(c[0].red), S(c[0].green), S(c[0].blue), S(box.plane_light[0])};
  if constexpr (kFronts > 1) {
    const auto here = second == entry;
    colour = {select(here, S(c[1].red), colour.red), select(here, S(c[1].green), colour.green),
              select(here, S(c[1].blue), colour.blue), select(here, S(box.plane_light[1]), colour.light)};
  }
  if constexpr (kFronts > 2) {
    const auto here = third == entry;
    colour = {select(here, S(c[2].red), colour.red), select(here, S(c[2].green), colour.green),
              select(here, S(c[2].blue), colour.blue), select(here, S(box.plane_light[2]), colour.light)};
  }
  see<S, kView>(tile, i, nearest, entry, colour, box);
}

template <class S, CastView kView>
inline void meetEllipsoid(const Tile& tile, const CastSurface& s, int i) {
  const S x = load<S>(tile.x + i), y = load<S>(tile.y + i);
  const S root = evaluate(s.root, x, y);
  const auto met = root >= S(0.0F);
  if (laneBits(met) == 0) return;
  const S w = sqrt(max(root, S(0.0F))) + evaluate(s.rest, x, y);
  const auto nearest = met & (w > load<S>(tile.buffer.w + i));
  if (laneBits(nearest) == 0) return;
  const S gx = evaluate(s.gradient[0], x, y) + S(s.gradient_w[0]) * w;
  const S gy = evaluate(s.gradient[1], x, y) + S(s.gradient_w[1]) * w;
  const S gz = evaluate(s.gradient[2], x, y) + S(s.gradient_w[2]) * w;
  const float* lamp = tile.scene.lamp;
  const S cosine = ((gx * S(lamp[0]) + gy * S(lamp[1])) + gz * S(lamp[2])) / sqrt((gx * gx + gy * gy) + gz * gz);
  see<S, kView>(tile, i, nearest, w, lit(s.colour, brightness(tile.scene, cosine)), s);
}

template <class S, CastView kView>
inline void meetCylinder(const Tile& tile, const CastSurface& s, int i) {
  const S x = load<S>(tile.x + i), y = load<S>(tile.y + i);
  const S zero(0.0F), axial = evaluate(s.axis[2], x, y);
  S w = nothingYet<S, kView>();
  auto on_side = zero > zero;
  if (s.has_side) {
    const S root = evaluate(s.root, x, y);
    const S w_side = sqrt(max(root, zero)) + evaluate(s.rest, x, y);
    on_side = (root >= zero) & (abs(S(s.axis_w[2]) * w_side + axial) <= unitAt<S, kView>(w_side));
    w = select(on_side, w_side, w);
  }
  if (s.has_cap) {
    const S w_cap = evaluate(s.cap, x, y);
    const S across_x = evaluate(s.axis[0], x, y) + S(s.axis_w[0]) * w_cap;
    const S across_y = evaluate(s.axis[1], x, y) + S(s.axis_w[1]) * w_cap;
    const S unit = unitAt<S, kView>(w_cap);
    const auto on_cap = (!on_side) & (across_x * across_x + across_y * across_y <= unit * unit);
    w = select(on_cap, w_cap, w);
  }
  const auto nearest = w > load<S>(tile.buffer.w + i);
  if (laneBits(nearest) == 0) return;
  const S cosine = S(s.side_light_w) + evaluate(s.side_light, x, y) / w;
  const S light = brightness(tile.scene, cosine);
  const Lit<S> side = lit(s.colour, light);
  const CastColour& cap = s.cap_colour;
  see<S, kView>(tile, i, nearest, w,
                Lit<S>{select(on_side, side.red, S(cap.red)), select(on_side, side.green, S(cap.green)),
                       select(on_side, side.blue, S(cap.blue)), select(on_side, light, S(s.cap_light))},
                s);
}

/// The side and two spheres: what lies within the ends of a side that is left open is never seen.
template <class S, CastView kView>
inline void meetCapsule(const Tile& tile, const CastSurface& s, int i) {
  const S x = load<S>(tile.x + i), y = load<S>(tile.y + i), zero(0.0F);
  S w = nothingYet<S, kView>(), turn = zero;
  if (s.has_side) {
    const S root = evaluate(s.root, x, y);
    const S w_side = sqrt(max(root, zero)) + evaluate(s.rest, x, y);
    const auto met =
        (root >= zero) & (abs(S(s.axis_w[2]) * w_side + evaluate(s.axis[2], x, y)) <= unitAt<S, kView>(w_side));
    w = select(met, w_side, w), turn = select(met, S(s.side_light_w), turn);
  }
  auto on_side = w > nothingYet<S, kView>();
  for (int end = 0; end < 2; ++end) {
    const S root = evaluate(s.end_root[end], x, y);
    const S w_end = sqrt(max(root, zero)) + evaluate(s.end_rest[end], x, y);
    const auto met = (root >= zero) & (w_end > w);
    w = select(met, w_end, w), turn = select(met, S(s.end_light_w[end]), turn);
    on_side = on_side & !met;
  }
  const auto nearest = w > load<S>(tile.buffer.w + i);
  if (laneBits(nearest) == 0) return;
  const S light = select(on_side, evaluate(s.side_light, x, y), evaluate(s.end_light, x, y));
  see<S, kView>(tile, i, nearest, w, lit(s.colour, brightness(tile.scene, turn + light / w)), s);
}

/// Everything solid that may appear in the tile.
template <class S, CastView kView>
inline void castSurfaces(const Tile& tile) {
  const CastRow& row = tile.candidates;
  forCandidates<S>(tile, [&](int k) {
    const CastSurface& surface = tile.scene.surfaces[row.surface[k]];
    const auto within = [&](auto visit) {
      forPacksWithin<S>(tile, row.x_low[k], row.x_high[k], row.y_low[k], row.y_high[k], visit);
    };
    switch (surface.kind) {
      case CastKind::kBox:
        if (surface.fronts == 1) within([&](int i) { meetBox<S, kView, 1>(tile, surface, i); });
        if (surface.fronts == 2) within([&](int i) { meetBox<S, kView, 2>(tile, surface, i); });
        if (surface.fronts == 3) within([&](int i) { meetBox<S, kView, 3>(tile, surface, i); });
        return;
      case CastKind::kEllipsoid:
        return within([&](int i) { meetEllipsoid<S, kView>(tile, surface, i); });
      case CastKind::kCylinder:
        return within([&](int i) { meetCylinder<S, kView>(tile, surface, i); });
      case CastKind::kCapsule:
        return within([&](int i) { meetCapsule<S, kView>(tile, surface, i); });
      case CastKind::kMesh:
        return castMesh<S, kView>(tile, surface, row.x_low[k], row.x_high[k], row.y_low[k], row.y_high[k]);
      case CastKind::kShadow:
        return;
    }
  });
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
