#pragma once

/// @file Whether two convex shapes overlap, by Minkowski portal refinement [Snethen 2008, Game Programming Gems 7].
///
/// Library libccd, tolerance 1e-6 m. Only whether: the library's depth lies along the ray from centre to centre, is not
/// the shortest way out, and as the start of the search for that (least_depth.h) its normal is no better than the
/// direction from centre to centre and costs twice as much. Its other method, GJK with EPA, loses contacts and digits
/// with curved shapes. No allocation.

#include "murosimf/algorithms/collision/least_depth.h"

namespace murosimf {

bool overlapByPortal(const ConvexPair& pair);

}  // namespace murosimf
