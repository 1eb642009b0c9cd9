#pragma once

/// @file Surfaces of triangles as the ray caster's kernels read them: plain numbers, alike for every instruction set.
///
/// A mesh is a tree of boxes, eight to a node, with up to eight triangles to a leaf: what stands side by side is worked
/// on in one register, whatever the number of pixels in another. Corners are given in the mesh's own frame S.

#include <cstdint>

#include "murosimf/algorithms/cast_colour.h"

namespace murosimf {

inline constexpr int kMeshWidth = 8;
inline constexpr int kMeshStack = 512;  ///< nodes that wait while a tree is walked through, at most

/// Eight boxes. A child from 0 on is a node; below 0, the group of triangles ~child. Places without a child hold a box
/// that nothing meets: its low ends lie above its high ends.
struct alignas(32) CastMeshNode {
  float low[3][kMeshWidth], high[3][kMeshWidth];  ///< [axis][child]
  std::int32_t child[kMeshWidth];
};

/// Eight triangles; places without one repeat a point.
struct alignas(32) CastTriangles {
  float corner[3][3][kMeshWidth];  ///< [corner][axis][triangle], counterclockwise seen from outside where `closed`
};

struct CastMesh {
  const CastMeshNode* nodes;  ///< the first is the root
  const CastTriangles* groups;
  const CastColour* colours;  ///< of triangle k of group g at 8 g + k; null: the surface's
  std::int32_t closed;        ///< a surface without rim: what is seen from behind is hidden by what is seen from front
};

/// A mesh as seen from a camera, by inverse depth w, or along the parallel rays of a lamp, by height h.
///
/// Let m be the origin of S, u the corners; a, b the axes across, all in S. A point of the picture lies at
/// (xi, eta) = (x, y) - middle. Three corners u_i on a ray's left make it pass inside: with an edge's D = u_j - u_i and
/// c = u_i x u_j, its side is told by the form of coefficients D . edge[k] + c . area[k] in xi, eta, 1:
///   camera  rays d = d_0 + xi a + eta b:        d . ((m + u_i) x (m + u_j)) = D . (d x m) + d . c
///   lamp    points p = xi a + eta b, rays l:    l . ((u_i - p) x (u_j - p)) = D . (p x l) + l . c
/// With the normal n of the triangle, w or h is the form (n . top[k] + [k = 1's place] lift n . u_0) divided by
/// n . bottom + sink n . u_0. Forms are taken about the middle of the mesh, where float is enough.
struct CastMeshView {
  CastMesh mesh;
  float middle[2];               ///< slopes of m from a camera, place of m across a lamp's rays
  float edge[3][3], area[3][3];  ///< [of xi, of eta, constant][axis of S]
  float top[3][3], bottom[3];    ///< [of xi, of eta, constant][axis of S]
  float lift, sink;              ///< 1 where n . u_0 counts, else 0
  float row[3][3], offset[3];    ///< a point of S seen in the camera's or lamp's axes: row . u + offset
  float lamp[3];                 ///< unit vector towards the lamp, in S
  float facing;                  ///< sign of the denominator for a triangle that faces camera or lamp
  float slack;                   ///< what rounding may move a point by [m]
  std::int32_t perspective;      ///< 1: camera, 0: lamp
};

}  // namespace murosimf
