#pragma once

/// @file What a pixel sees when a surface is met. A part of the ray caster's kernel.

#include "murosimf/algorithms/cast_tile.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Whose rays are cast: those of a camera, which keeps the nearest surface, or those that come from the lamp, of which
/// it only matters whether something stands in their way.
enum class CastView { kCamera, kLamp };

/// "Inverse depth" of a point that lies in a shadow: nothing lies above it any more.
inline constexpr float kInShadow = 3e38F;

template <class S>
struct Lit {
  S red, green, blue, light;
};

/// Light that a surface gives back whose normal has this cosine with the lamp's direction.
template <class S>
inline S brightness(const CastScene& scene, S cosine) {
  return S(scene.ambient) + S(1.0F - scene.ambient) * max(cosine, S(0.0F));
}
template <class S>
inline Lit<S> lit(const CastColour& colour, S light) {
  return {S(colour.red) * light, S(colour.green) * light, S(colour.blue) * light, light};
}

/// Overwrites the lanes of pack i in which the surface was met nearest.
template <class S, CastView kView, class M>
inline void see(const Tile& tile, int i, M nearest, S w, const Lit<S>& colour, const CastSurface& surface) {
  TileBuffer& b = tile.buffer;
  if constexpr (kView == CastView::kLamp) {
    store(b.w + i, select(nearest, S(kInShadow), load<S>(b.w + i)));
    return;
  }
  store(b.w + i, select(nearest, w, load<S>(b.w + i)));
  store(b.red + i, select(nearest, colour.red, load<S>(b.red + i)));
  store(b.green + i, select(nearest, colour.green, load<S>(b.green + i)));
  store(b.blue + i, select(nearest, colour.blue, load<S>(b.blue + i)));
  store(b.label + i, select(nearest, S(surface.label), load<S>(b.label + i)));
  if (tile.scene.lamp_scene) store(b.light + i, select(nearest, colour.light, load<S>(b.light + i)));
  if (!keepsSurfaces(tile)) return;
  const S index(static_cast<float>(&surface - tile.scene.surfaces));
  store(b.surface + i, select(nearest, index, load<S>(b.surface + i)));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
