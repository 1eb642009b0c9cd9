#pragma once

/// @file What pressure sensors feel through a foot that is a convex hull.
///
/// A sole has four corners with a sensor each. The force on a vertex near its plane is shared by them as its place in
/// the rectangle says, bilinearly, so that their sum and, inside the rectangle, their centre of pressure are those of
/// the vertices.

#include <vector>

#include "murosimf/algorithms/ground_shape.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// The sole on the shape's row that vertices of its hull lie next to (within 1 mm of its plane), and each vertex's
/// shares: all zero farther than 1 cm from the plane. Without such a sole: number -1.
struct SoleShares {
  int sole = -1;
  std::vector<CornerShares> of_vertices;
};
SoleShares shareBySole(const PlacedShape& shape, const std::vector<SolePlace>& soles);

}  // namespace murosimf
