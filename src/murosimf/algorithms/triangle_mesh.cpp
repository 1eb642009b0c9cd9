#include "murosimf/algorithms/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

#include "murosimf/algorithms/mesh_tree.h"

namespace murosimf {
namespace {

/// Corners as kernels see them: in single precision.
using Point = std::array<float, 3>;

std::vector<Point> pointsOf(std::span<const Vector3> corners) {
  std::vector<Point> points;
  for (const Vector3& p : corners) {
    if (!std::isfinite(squaredNorm(p))) throw std::invalid_argument("triangle mesh: found a corner that is not finite");
    points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  return points;
}

void checkCorners(const TriangleCorners& triangle, std::size_t count) {
  for (const int corner : triangle) {
    if (corner < 0 || static_cast<std::size_t>(corner) >= count)
      throw std::invalid_argument("triangle mesh: found corner number " + std::to_string(corner) + " of " +
                                  std::to_string(count));
  }
}

Vector3 vectorOf(const Point& p) { return {p[0], p[1], p[2]}; }

/// A mesh while it is built.
struct Triangles {
  std::vector<Point> points;
  std::vector<TriangleCorners> corners;
  std::vector<Colour> colours;  // none, or as corners

  Vector3 at(const TriangleCorners& t, std::size_t k) const { return vectorOf(points[static_cast<std::size_t>(t[k])]); }
  bool hasArea(const TriangleCorners& t) const {
    return squaredNorm(cross(at(t, 1) - at(t, 0), at(t, 2) - at(t, 0))) > 0;
  }
};

/// Six times the volume that a closed surface encloses, negative where its triangles are turned inside out; 0 for one
/// with a rim, or whose triangles do not agree on what is outside. Corners at the same place are the same corner.
double enclosedVolume(const Triangles& mesh) {
  std::map<Point, int> known;
  std::map<std::pair<int, int>, int> runs;
  double volume = 0;
  for (const TriangleCorners& t : mesh.corners) {
    int place[3];
    for (std::size_t k = 0; k < 3; ++k)
      place[k] =
          known.try_emplace(mesh.points[static_cast<std::size_t>(t[k])], static_cast<int>(known.size())).first->second;
    for (int k = 0; k < 3; ++k) ++runs[{place[k], place[(k + 1) % 3]}];
    volume += dot(mesh.at(t, 0), cross(mesh.at(t, 1), mesh.at(t, 2)));
  }
  for (const auto& [edge, count] : runs) {
    const auto back = runs.find({edge.second, edge.first});
    if (back == runs.end() || back->second != count) return 0;
  }
  return volume;
}

MeshBox boxOf(const Triangles& mesh, const TriangleCorners& t) {
  MeshBox box = emptyBox();
  for (const int corner : t) {
    const Point& p = mesh.points[static_cast<std::size_t>(corner)];
    include({p, p}, box);
  }
  return box;
}

CastTriangles groupOf(const Triangles& mesh, const std::vector<int>& numbers) {
  CastTriangles group;
  for (std::size_t k = 0; k < kMeshWidth; ++k) {
    const bool used = k < numbers.size();
    const TriangleCorners& t = mesh.corners[static_cast<std::size_t>(numbers[used ? k : 0])];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point& p = mesh.points[static_cast<std::size_t>(t[used ? corner : 0])];
      for (std::size_t axis = 0; axis < 3; ++axis) group.corner[corner][axis][k] = p[axis];
    }
  }
  return group;
}

}  // namespace

TriangleMesh::TriangleMesh(std::span<const Vector3> corners, std::span<const TriangleCorners> triangles,
                           std::span<const Colour> colours) {
  if (!colours.empty() && colours.size() != triangles.size())
    throw std::invalid_argument("triangle mesh: found " + std::to_string(colours.size()) + " colours of " +
                                std::to_string(triangles.size()) + " triangles");
  Triangles mesh;
  mesh.points = pointsOf(corners);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    checkCorners(triangles[i], corners.size());
    if (!mesh.hasArea(triangles[i])) continue;
    mesh.corners.push_back(triangles[i]);
    if (!colours.empty()) mesh.colours.push_back(colours[i]);
  }
  if (mesh.corners.empty()) throw std::invalid_argument("triangle mesh: found no triangle that has an area");
  const double volume = enclosedVolume(mesh);
  if (volume < 0)
    for (TriangleCorners& t : mesh.corners) std::swap(t[1], t[2]);
  std::vector<MeshBox> boxes;
  for (const TriangleCorners& t : mesh.corners) boxes.push_back(boxOf(mesh, t));
  MeshTree tree = buildMeshTree(boxes);
  nodes_ = std::move(tree.nodes);
  for (const std::vector<int>& numbers : tree.groups) {
    groups_.push_back(groupOf(mesh, numbers));
    for (std::size_t k = 0; !colours.empty() && k < kMeshWidth; ++k) {
      const Colour& c = mesh.colours[static_cast<std::size_t>(numbers[std::min(k, numbers.size() - 1)])];
      colours_.push_back({c.red, c.green, c.blue});
    }
  }
  for (const MeshBox& box : boxes) {
    const auto reach = [&](std::size_t i) { return std::max<double>(std::fabs(box.low[i]), std::fabs(box.high[i])); };
    half_size_ = {std::max(half_size_.x, reach(0)), std::max(half_size_.y, reach(1)), std::max(half_size_.z, reach(2))};
  }
  triangle_count_ = static_cast<int>(mesh.corners.size());
  cast_ = {nodes_.data(), groups_.data(), colours_.empty() ? nullptr : colours_.data(), volume != 0 ? 1 : 0};
}

}  // namespace murosimf
