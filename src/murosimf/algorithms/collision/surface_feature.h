#pragma once

/// @file Flat and straight parts of two surfaces that face each other, and the contact points between them.
///
/// A body that stands on a face needs more points than the deepest one. Where both shapes turn flat faces (or straight
/// lines) to each other, both are projected along the normal n; the corners of what they share are the contact points,
/// the depth at each the distance of both surfaces along n. The shared polygon is cut by side planes one by one
/// [Sutherland, Hodgman 1974].

#include "murosimf/algorithms/collision/collision_shape.h"
#include "murosimf/algorithms/collision/contact_manifold.h"

namespace murosimf {

/// Up to 32 corners of a face, both ends of a line, or nothing where the surface is round.
struct SurfaceFeature {
  static constexpr int kMost = 32;
  UnsetArray<Vector3, kMost> points;
  int count = 0;           ///< 0: round or a corner; 2: a line; 3 or more: a face, counterclockwise seen from outside
  Vector3 normal;          ///< outward, unit length; of a face only
  std::uint32_t name = 0;  ///< which face or line of its shape
};

/// What the shape turns towards direction d_S (unit length), in its own frame S: the face whose normal, or the line
/// whose perpendicular, lies within 3 degrees of d. Of a face with more than 32 corners every second, third, ... stays.
void facingFeature(const CollisionShape& shape, const Vector3& d_S, SurfaceFeature& out);
/// The face of a box whose normal lies nearest to d_S, however far that is.
void facingFaceOfBox(const Vector3& half_size, const Vector3& d_S, SurfaceFeature& out);
/// From frame B into frame A.
void transformFeature(const Pose& X_AB, SurfaceFeature& feature);

/// The deepest overlap: its two surface points lie depth apart along the manifold's normal.
struct DeepestOverlap {
  double depth = 0;  ///< [m] > 0
  Vector3 midpoint;  ///< between both surface points
};

/// Fills out.points from what both shapes turn to each other, in one frame. out.normal must be set. Where the features
/// share nothing the deepest overlap alone is left; it is among the points in any case, and no point exceeds its depth.
void pointsBetween(const SurfaceFeature& a, const SurfaceFeature& b, const DeepestOverlap& overlap,
                   ContactManifold& out);

}  // namespace murosimf
