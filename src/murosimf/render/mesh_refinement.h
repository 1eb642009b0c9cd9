#pragma once

/// @file Meshes made finer, so that a lens may bend them corner by corner.

#include <optional>
#include <vector>

#include "murosimf/algorithms/triangle_mesh.h"
#include "murosimf/render/mesh.h"

namespace murosimf {

/// Stretched along its axes, its normals with it, and moved.
Mesh stretched(const Mesh& mesh, const Vector3& stretch, const Vector3& offset = {});

void append(const Mesh& other, Mesh& mesh);

/// The same surface in triangles none of whose edges is longer than this [m]: edges are halved until they are short, so
/// neighbours agree on their corners and no crack opens. Cost: grows with the number of triangles.
Mesh refined(const Mesh& mesh, double longest_edge);

/// The triangles of one colour, flat.
struct ColouredMesh {
  std::optional<Colour> colour;  ///< none: that of what is drawn
  Mesh mesh;
};
std::vector<ColouredMesh> meshesOf(const TriangleMesh& triangles);

}  // namespace murosimf
