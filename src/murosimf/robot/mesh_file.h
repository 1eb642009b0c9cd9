#pragma once

/// @file Reads the surfaces of bodies from files of triangles: STL (binary, text) and OBJ.
///
/// A body is drawn as the triangles and collides as the convex hull of the corners. Numbers are read in single
/// precision (6e-8 of a coordinate), as assimp keeps them.

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/algorithms/triangle_mesh.h"

namespace murosimf {

struct MeshFile {
  std::vector<Vector3> points;             ///< corners of triangles, each place once, in rising order of x, y, z
  std::vector<TriangleCorners> triangles;  ///< in the order of the file; polygons are cut into triangles
  std::vector<Colour> colours;             ///< of triangles, where an OBJ file names materials; else none
  std::string problem;                     ///< why there are no points: what was found, what was expected
};

/// Reads at most 64 MiB. Never throws for what the file holds. Cost: some 0.2 s for 100 000 triangles.
MeshFile readMeshFile(const std::filesystem::path& file);

}  // namespace murosimf
