#include "murosimf/render/mesh.h"

#include <numbers>

namespace murosimf {

namespace {

using Point = std::array<float, 3>;

Point toPoint(const Vector3& p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

/// A flat convex polygon, its corners counterclockwise.
void addFan(Mesh& mesh, const std::vector<Vector3>& corners, const Vector3& normal) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& corner : corners) mesh.vertices.push_back({toPoint(corner), toPoint(normal)});
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
  }
}

SinCos<double> turn(int step, int slices) { return sincos(2 * std::numbers::pi * step / slices); }

/// A disc of radius 1 at height z that looks up or down.
void addDisc(Mesh& mesh, double z, bool up, int slices) {
  std::vector<Vector3> rim;
  for (int i = 0; i < slices; ++i) {
    const SinCos<double> a = turn(up ? i : -i, slices);
    rim.push_back({a.cos, a.sin, z});
  }
  addFan(mesh, rim, {0, 0, up ? 1.0 : -1.0});
}

/// Joins two rows of slices + 1 vertices each: the lower one begins at `low`, the upper one at `high`.
void addBand(Mesh& mesh, std::uint32_t low, std::uint32_t high, int slices) {
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(slices); ++i) {
    mesh.indices.insert(mesh.indices.end(), {low + i, low + i + 1, high + i, high + i, low + i + 1, high + i + 1});
  }
}

/// A ring of vertices about z, the first repeated at the end. @returns the number of its first vertex
std::uint32_t addRing(Mesh& mesh, double radius, double z, double normal_out, double normal_up, int slices) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i <= slices; ++i) {
    const SinCos<double> a = turn(i, slices);
    mesh.vertices.push_back(
        {toPoint({radius * a.cos, radius * a.sin, z}), toPoint({normal_out * a.cos, normal_out * a.sin, normal_up})});
  }
  return first;
}

}  // namespace

Mesh makeBoxMesh() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vector3 n, u, v;
      n[axis] = side, u[(axis + 1) % 3] = side, v[(axis + 2) % 3] = 1;
      addFan(mesh, {n - u - v, n + u - v, n + u + v, n - u + v}, n);
    }
  }
  return mesh;
}

Mesh makeSphereMesh(int slices) {
  Mesh mesh;
  const int rows = slices / 2;
  for (int row = 0; row <= rows; ++row) {
    const SinCos<double> latitude = sincos(std::numbers::pi * (static_cast<double>(row) / rows - 0.5));
    const std::uint32_t ring = addRing(mesh, latitude.cos, latitude.sin, latitude.cos, latitude.sin, slices);
    if (row > 0) addBand(mesh, ring - static_cast<std::uint32_t>(slices) - 1, ring, slices);
  }
  return mesh;
}

Mesh makeCylinderMesh(int slices) {
  Mesh mesh;
  const std::uint32_t low = addRing(mesh, 1, -1, 1, 0, slices), high = addRing(mesh, 1, 1, 1, 0, slices);
  addBand(mesh, low, high, slices);
  addDisc(mesh, 1, true, slices);
  addDisc(mesh, -1, false, slices);
  return mesh;
}

Mesh makeConeMesh(int slices) {
  Mesh mesh;
  const double slope = std::numbers::sqrt2 / 2;
  const std::uint32_t low = addRing(mesh, 1, 0, slope, slope, slices), tip = addRing(mesh, 0, 1, slope, slope, slices);
  addBand(mesh, low, tip, slices);
  addDisc(mesh, 0, false, slices);
  return mesh;
}

Mesh makeHullMesh(const ConvexHull& hull) {
  Mesh mesh;
  for (const ConvexHull::Face& face : hull.faces()) {
    std::vector<Vector3> corners;
    for (const int vertex : hull.corners(face)) corners.push_back(hull.vertex(vertex));
    addFan(mesh, corners, face.normal);
  }
  return mesh;
}

MeshLibrary::MeshLibrary() : meshes_{makeBoxMesh(), makeSphereMesh(), makeCylinderMesh(), makeConeMesh()} {}

int MeshLibrary::add(Mesh mesh) {
  meshes_.push_back(std::move(mesh));
  return size() - 1;
}

int MeshLibrary::numberOf(const std::shared_ptr<const ConvexHull>& hull) {
  const auto [place, is_new] = hulls_.try_emplace(hull, size());
  if (is_new) add(makeHullMesh(*hull));
  return place->second;
}

}  // namespace murosimf
