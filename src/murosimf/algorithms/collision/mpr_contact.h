#pragma once

/// @file Whether two convex shapes overlap, by Minkowski portal refinement [Snethen 2008, Game Programming Gems 7].
///
/// Library libccd, tolerance 1e-6 m. Its normal is that of the surface where a ray from centre to centre leaves the
/// difference of the shapes: a good first guess of the shortest way out, not the shortest itself. No allocation.

#include "murosimf/algorithms/collision/least_depth.h"

namespace murosimf {

/// @return false if the shapes do not overlap. `normal`: unit length, from B to A, in A's frame.
bool overlapByPortal(const ConvexPair& pair, Vector3& normal);

}  // namespace murosimf
