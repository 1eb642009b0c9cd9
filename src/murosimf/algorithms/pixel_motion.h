#pragma once

/// @file Where the point that a pixel sees was in the picture before: motion vectors, exact through the lens.
///
/// A point p_C = depth (x, y, 1) of the part seen is carried back to where this part was, seen from where the camera
/// was, and projected: motion = (u, v) - project(X_C'W X_WS' X_SW X_WC p_C), with primes for before. The ground does
/// not move; the sky turns with the camera alone.

#include <span>

#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/algorithms/ray_table.h"

namespace murosimf {

/// Overwrites picture.motion. The picture must have depth and part, and be of `scene` and `X_WC`.
/// @param before  poses X_WS' of the scene's drawables, in their order
/// Cost: 640 x 480 some 10 ms, more than the picture itself: it projects every pixel in double precision.
void findMotion(const RayTable& rays, const RayScene& scene, const Pose& X_WC, std::span<const Pose> before,
                const Pose& X_WC_before, Picture& picture);

}  // namespace murosimf
