#pragma once

/// @file What collision detection finds: where two bodies overlap, how deep, and which way out is shortest.

#include <cstdint>

#include "murosimf/algorithms/collision/unset_array.h"
#include "murosimf/math/vec3.h"

namespace murosimf {

struct ContactPoint {
  Vector3 position;           ///< midway between both surfaces [m], world
  double depth = 0;           ///< along the manifold's normal [m] > 0
  std::uint32_t feature = 0;  ///< the same from frame to frame for the same corners, edges and faces
};

/// Up to four points of one pair of shapes. Four carry a body that stands as well as more would.
struct ContactManifold {
  Vector3 normal{0, 0, 1};  ///< unit length, from B to A, the direction of the force on A; world
  int count = 0;            ///< 0: the shapes do not touch
  double apart = 0;         ///< where count is 0: the shapes' distance is no less [m]; 0: nothing is known of it
  ContactPoint points[4];
};

/// The deepest point, for who wants one point a pair [Friedmann 2007]. Requires count > 0.
inline const ContactPoint& deepest(const ContactManifold& manifold) {
  int best = 0;
  for (int i = 1; i < manifold.count; ++i)
    if (manifold.points[i].depth > manifold.points[best].depth) best = i;
  return manifold.points[best];
}

/// Contact points of a pair before at most four of them are chosen.
struct CandidatePoints {
  static constexpr int kMost = 80;
  UnsetArray<ContactPoint, kMost> points;
  int count = 0;
  /// Points that do not overlap are dropped; of points less than 1e-9 m apart the first one stays, with the larger
  /// depth.
  void add(const Vector3& position, double depth, std::uint32_t feature);
};

/// Fills out.points: the deepest candidate, the one farthest from it, the one that spans the largest triangle with both
/// and the one that adds most area on the other side, as far as there is any; all of them where they are no more than
/// four. Needs out.normal.
void chooseFour(const CandidatePoints& candidates, ContactManifold& out);

}  // namespace murosimf
