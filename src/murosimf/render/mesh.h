#pragma once

/// @file Surfaces made of triangles, as a graphics card wants them: what every shape is drawn with.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "murosimf/algorithms/collision/convex_hull.h"

namespace murosimf {

/// Position and outward unit normal, in the shape's frame.
struct MeshVertex {
  std::array<float, 3> position, normal;
};

/// Every three indices are a triangle, counterclockwise seen from outside.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// All within one unit of the origin: a shape's half sizes stretch them.
Mesh makeBoxMesh();
Mesh makeSphereMesh(int slices = 24);
Mesh makeCylinderMesh(int slices = 24);  ///< along z, from -1 to 1
Mesh makeConeMesh(int slices = 16);      ///< its tip at z = 1, its base of radius 1 at z = 0
/// In metres.
Mesh makeHullMesh(const ConvexHull& hull);

/// The meshes that draw lists speak of by number. Only grows, so that whoever keeps copies (a graphics card) need
/// add what is new.
class MeshLibrary {
 public:
  static constexpr int kBox = 0, kSphere = 1, kCylinder = 2, kCone = 3;

  MeshLibrary();
  int add(Mesh mesh);
  /// The number of a hull's mesh; made at the first call.
  int numberOf(const std::shared_ptr<const ConvexHull>& hull);

  int size() const { return static_cast<int>(meshes_.size()); }
  const Mesh& operator[](int number) const { return meshes_[static_cast<std::size_t>(number)]; }

 private:
  std::vector<Mesh> meshes_;
  std::map<std::shared_ptr<const ConvexHull>, int> hulls_;
};

}  // namespace murosimf
