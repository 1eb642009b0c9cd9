#pragma once

/// @file A surface of triangles as cameras draw it, with the tree of boxes by which rays find its triangles.
///
/// Built once and shared by everything that has this form; only its pose changes. The tree is split where the surface
/// area heuristic is least [MacDonald & Booth 1990], over twelve bins of the triangles' middles [Wald 2007], eight
/// branches to a node. Nothing is drawn twice or left out, whatever the tree.
/// Cost: building takes some 1 us a triangle; memory some 100 bytes a triangle.

#include <array>
#include <span>
#include <vector>

#include "murosimf/algorithms/cast_mesh_data.h"
#include "murosimf/algorithms/shape.h"
#include "murosimf/math/vec3.h"

namespace murosimf {

/// A triangle by the numbers of its corners, counterclockwise seen from outside.
using TriangleCorners = std::array<int, 3>;

class TriangleMesh {
 public:
  /// @param corners    in the mesh's frame S, which should stand near their middle [m]
  /// @param triangles  numbers of corners; a triangle without area is left out
  /// @param colours    one a triangle; none: all have the colour of what is drawn
  /// @throws std::invalid_argument for numbers that are no corner's, corners that are not finite, colours of another
  ///   count, and when no triangle is left
  TriangleMesh(std::span<const Vector3> corners, std::span<const TriangleCorners> triangles,
               std::span<const Colour> colours = {});
  TriangleMesh(const TriangleMesh&) = delete;
  TriangleMesh& operator=(const TriangleMesh&) = delete;

  const CastMesh& cast() const { return cast_; }
  int triangleCount() const { return triangle_count_; }
  int nodeCount() const { return static_cast<int>(nodes_.size()); }
  /// True where each edge belongs to two triangles that run along it in opposite directions: the surface encloses
  /// something, and the backs of its triangles are never seen.
  bool isClosed() const { return cast_.closed != 0; }
  /// Largest |coordinate| of a corner in each axis: half edges of a box about S's origin that holds all [m].
  const Vector3& halfSize() const { return half_size_; }

 private:
  std::vector<CastMeshNode> nodes_;
  std::vector<CastTriangles> groups_;
  std::vector<CastColour> colours_;
  Vector3 half_size_;
  int triangle_count_ = 0;
  CastMesh cast_{};
};

}  // namespace murosimf
