#pragma once

/// @file How far a ray goes until it meets a shape, in closed forms and double precision: for laser scanners.
///
/// Ray        p + t d, d of length 1, in the shape's frame S; t of the first point at t >= 0, infinity where there is
///            none. A ray that begins inside goes 0.
/// box        slabs: the largest entry of the three axes before the smallest exit [Kay & Kajiya 1986]
/// ellipsoid  |p' + t d'|^2 = 1, all divided by the radii
/// cylinder   its side, x^2 + y^2 = R^2, cut by its two ends
/// capsule    its side and the spheres about its ends
/// mesh       its triangles [Moeller & Trumbore 1997], found through the tree of boxes; seen from both sides, so that a
///            ray that begins inside meets the far side. Corners are kept as floats: 1e-7 of its size.
/// Cost       10 to 40 operations; a mesh about 20 operations a level of its tree, and 30 a triangle that is near.

#include "murosimf/algorithms/shape.h"
#include "murosimf/algorithms/triangle_mesh.h"

namespace murosimf {

/// Any shape but a convex hull, which is cast as a mesh.
double rayDistance(const Shape& shape, const Vector3& p, const Vector3& d);
double rayDistance(const TriangleMesh& mesh, const Vector3& p, const Vector3& d);

}  // namespace murosimf
