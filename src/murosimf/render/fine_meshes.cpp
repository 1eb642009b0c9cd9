#include "murosimf/render/fine_meshes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/render/mesh_refinement.h"

namespace murosimf {

namespace {

constexpr double kOutline = 0.15;  // how far a polygon may lie within the circle it stands for [px]

/// Even, as spheres have half as many rows.
int slicesFor(double radius_in_pixels) {
  return std::max(8, 2 * static_cast<int>(std::ceil(0.5 * kPi * std::sqrt(radius_in_pixels / (2 * kOutline)))));
}

/// Edges of a shape of this size at a fineness [m].
double edgeAt(double bounding_radius, int fineness) { return std::ldexp(2 * bounding_radius, -fineness); }

Mesh makeMesh(const Shape& shape, double longest) {
  const Vector3& a = shape.half_size;
  const double widest = shape.kind == ShapeKind::kEllipsoid ? max(a.x, max(a.y, a.z)) : max(a.x, a.y);
  const int slices = slicesFor(widest * FineMeshes::kLongestEdge / longest);
  switch (shape.kind) {
    case ShapeKind::kBox:
      return stretched(makeBoxMesh(), a);
    case ShapeKind::kEllipsoid:
      return stretched(makeSphereMesh(slices), a);
    case ShapeKind::kCylinder:
      return stretched(makeCylinderMesh(slices), a);
    case ShapeKind::kCapsule: {
      Mesh mesh = stretched(makeCylinderMesh(slices), a);
      for (const double end : {-a.z, a.z})
        append(stretched(makeSphereMesh(slices), {a.x, a.x, a.x}, {0, 0, end}), mesh);
      return mesh;
    }
    case ShapeKind::kConvex:
      break;
  }
  throw std::invalid_argument("a convex hull is drawn as a mesh, and this one has none");
}

}  // namespace

int FineMeshes::finenessFor(double bounding_radius, double pixel) {
  const double wanted = std::log2(2 * bounding_radius / (kLongestEdge * pixel));
  return static_cast<int>(std::ceil(std::clamp<double>(wanted, kCoarsest, kFinest)));
}

std::vector<FineMeshes::Part> FineMeshes::make(const Drawable& drawable, int fineness) {
  const double longest = edgeAt(boundingRadius(outlineOf(drawable)), fineness);
  if (!drawable.mesh) return {{library_.add(refined(makeMesh(drawable.shape, longest), longest)), std::nullopt, true}};
  std::vector<Part> parts;
  for (const ColouredMesh& part : meshesOf(*drawable.mesh))
    parts.push_back({library_.add(refined(part.mesh, longest)), part.colour, drawable.mesh->isClosed()});
  kept_.push_back(drawable.mesh);
  return parts;
}

std::span<const FineMeshes::Part> FineMeshes::parts(const Drawable& drawable, int fineness) {
  const Vector3& a = drawable.shape.half_size;
  const Key key = drawable.mesh ? Key{drawable.mesh.get(), ShapeKind::kConvex, 0, 0, 0, fineness}
                                : Key{nullptr, drawable.shape.kind, a.x, a.y, a.z, fineness};
  const auto place = known_.find(key);
  if (place != known_.end()) return place->second;
  return known_.emplace(key, make(drawable, fineness)).first->second;
}

}  // namespace murosimf
