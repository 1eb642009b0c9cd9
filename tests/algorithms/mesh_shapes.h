#pragma once

/// @file Shapes as triangles, for tests and benchmarks of cameras: the same bits on every machine.

#include <memory>
#include <vector>

#include "murosimf/algorithms/ray_scene.h"

namespace murosimf::mesh_shapes {

struct Triangles {
  std::vector<Vector3> corners;
  std::vector<TriangleCorners> triangles;
  std::shared_ptr<const TriangleMesh> mesh() const { return std::make_shared<TriangleMesh>(corners, triangles); }
};

/// A grid of columns x rows four-sided cells, each cut into two; corner(i, j) for i in [0, columns], j in [0, rows].
/// Counterclockwise where (i, j) run to the right and up.
template <class Corner>
void addGrid(int columns, int rows, Corner corner, Triangles& to) {
  const int first = static_cast<int>(to.corners.size());
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) to.corners.push_back(corner(i, j));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = first + j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = a + columns + 1;
      to.triangles.push_back({a, b, c});
      to.triangles.push_back({a, c, d});
    }
}

/// A box with 2 cells^2 triangles a face.
inline Triangles boxOf(const Vector3& edges, int cells) {
  Triangles box;
  for (const double side : {-1.0, 1.0})
    for (int axis = 0; axis < 3; ++axis)
      addGrid(
          cells, cells,
          [&](int i, int j) {
            Vector3 p;
            p[axis] = side * 0.5 * edges[axis];
            const int u = (axis + (side > 0 ? 1 : 2)) % 3, v = 3 - axis - u;
            p[u] = (static_cast<double>(i) / cells - 0.5) * edges[u],
            p[v] = (static_cast<double>(j) / cells - 0.5) * edges[v];
            return p;
          },
          box);
  return box;
}

/// Degrees of longitude and latitude; its corners lie on the ellipsoid.
inline Triangles ellipsoidOf(const Vector3& radii, int columns) {
  Triangles out;
  const int rows = columns / 2;
  addGrid(
      columns, rows,
      [&](int i, int j) {
        const double a = 2 * kPi * (i % columns) / columns, e = kPi * (static_cast<double>(j) / rows - 0.5);
        const SinCos<double> around = sincos(a), up = sincos(e);
        const double r = j == 0 || j == rows ? 0.0 : up.cos;
        return Vector3{radii.x * r * around.cos, radii.y * r * around.sin, radii.z * up.sin};
      },
      out);
  return out;
}

/// Side and caps of a cylinder, each cap a fan about its middle.
inline Triangles cylinderOf(double radius, double half_length, int columns) {
  Triangles out;
  addGrid(
      columns, 3,
      [&](int i, int j) {
        const double a = 2 * kPi * (i % columns) / columns, r = j == 0 || j == 3 ? 0.0 : radius;
        const SinCos<double> around = sincos(a);
        return Vector3{r * around.cos, r * around.sin, j < 2 ? -half_length : half_length};
      },
      out);
  return out;
}

/// A box, a cylinder or an ellipsoid; `columns` around.
inline Triangles meshOf(const Shape& shape, int columns) {
  if (shape.kind == ShapeKind::kBox) return boxOf(shape.half_size * 2.0, columns / 4);
  if (shape.kind == ShapeKind::kCylinder) return cylinderOf(shape.half_size.x, shape.half_size.z, columns);
  return ellipsoidOf(shape.half_size, columns);
}

/// Every drawable of a scene as a mesh; equal shapes share one.
inline void drawAsMeshes(int columns, RayScene& scene) {
  std::vector<std::pair<Shape, std::shared_ptr<const TriangleMesh>>> made;
  for (Drawable& d : scene.drawables) {
    for (const auto& [shape, mesh] : made)
      if (shape == d.shape) d.mesh = mesh;
    if (!d.mesh) d.mesh = made.emplace_back(d.shape, meshOf(d.shape, columns).mesh()).second;
  }
}

}  // namespace murosimf::mesh_shapes
