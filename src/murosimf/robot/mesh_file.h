#pragma once

/// @file Reads the surfaces of bodies from files of triangles: STL (binary, text) and OBJ.
///
/// Only the corners are of interest: a body collides as the convex hull of its mesh. Numbers are read in single
/// precision (6e-8 of a coordinate), as assimp keeps them.

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf {

struct MeshPoints {
  std::vector<Vector3> points;  ///< corners of triangles and polygons, each place once, in rising order of x, y, z
  std::string problem;          ///< why there are none: what was found, what was expected
};

/// Reads at most 64 MiB. Never throws for what the file holds. Cost: some 0.1 s for 100 000 triangles.
MeshPoints readMeshPoints(const std::filesystem::path& file);

}  // namespace murosimf
