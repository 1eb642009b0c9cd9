#include "murosimf/render/mesh_refinement.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace murosimf {

namespace {

using Corners = std::array<std::uint32_t, 3>;

Vector3 vectorOf(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }
std::array<float, 3> toFloats(const Vector3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// A mesh while its edges are halved.
class Refinement {
 public:
  Refinement(const Mesh& mesh, double longest_edge) : limit_(longest_edge * longest_edge) {
    out_.vertices = mesh.vertices;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      split({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }
  Mesh take() { return std::move(out_); }

 private:
  double squaredEdge(std::uint32_t a, std::uint32_t b) const {
    return squaredNorm(vectorOf(out_.vertices[a].position) - vectorOf(out_.vertices[b].position));
  }
  /// Neighbours with the same corners get the same corner in the middle.
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] =
        middles_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(out_.vertices.size()));
    if (is_new) {
      const MeshVertex p = out_.vertices[a], q = out_.vertices[b];
      out_.vertices.push_back({toFloats((vectorOf(p.position) + vectorOf(q.position)) * 0.5),
                               toFloats(normalized(vectorOf(p.normal) + vectorOf(q.normal)))});
    }
    return place->second;
  }
  void split(Corners t) {
    const std::array<double, 3> length{squaredEdge(t[0], t[1]), squaredEdge(t[1], t[2]), squaredEdge(t[2], t[0])};
    const auto longest = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
    if (length[longest] <= limit_) {
      out_.indices.insert(out_.indices.end(), t.begin(), t.end());
      return;
    }
    const std::uint32_t a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3], half = middle(a, b);
    split({a, half, c});
    split({half, b, c});
  }

  double limit_;
  Mesh out_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

int groupCount(const CastMesh& mesh, int nodes) {
  int count = 0;
  for (int node = 0; node < nodes; ++node)
    for (const std::int32_t child : mesh.nodes[node].child)
      if (child < 0) count = std::max(count, ~child + 1);
  return count;
}

void addFlat(const std::array<Vector3, 3>& corners, Mesh& mesh) {
  const Vector3 area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (!(squaredNorm(area) > 0)) return;  // what fills a group
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& p : corners) mesh.vertices.push_back({toFloats(p), toFloats(normalized(area))});
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

}  // namespace

Mesh stretched(const Mesh& mesh, const Vector3& stretch, const Vector3& offset) {
  Mesh out = mesh;
  for (MeshVertex& v : out.vertices) {
    const Vector3 p = vectorOf(v.position), n = vectorOf(v.normal);
    v.position = toFloats(Vector3{p.x * stretch.x, p.y * stretch.y, p.z * stretch.z} + offset);
    v.normal = toFloats(normalized(Vector3{n.x / stretch.x, n.y / stretch.y, n.z / stretch.z}));
  }
  return out;
}

void append(const Mesh& other, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

Mesh refined(const Mesh& mesh, double longest_edge) { return Refinement(mesh, longest_edge).take(); }

std::vector<ColouredMesh> meshesOf(const TriangleMesh& triangles) {
  const CastMesh& cast = triangles.cast();
  std::map<std::tuple<float, float, float>, Mesh> by_colour;
  Mesh plain;
  for (int group = 0; group < groupCount(cast, triangles.nodeCount()); ++group) {
    for (int k = 0; k < kMeshWidth; ++k) {
      std::array<Vector3, 3> corners;
      for (int i = 0; i < 3; ++i) {
        const auto& p = cast.groups[group].corner[i];
        corners[static_cast<std::size_t>(i)] = {p[0][k], p[1][k], p[2][k]};
      }
      if (cast.colours == nullptr) {
        addFlat(corners, plain);
        continue;
      }
      const CastColour& c = cast.colours[kMeshWidth * group + k];
      addFlat(corners, by_colour[{c.red, c.green, c.blue}]);
    }
  }
  std::vector<ColouredMesh> parts;
  if (!plain.indices.empty()) parts.push_back({std::nullopt, std::move(plain)});
  for (auto& [c, mesh] : by_colour)
    parts.push_back({Colour{std::get<0>(c), std::get<1>(c), std::get<2>(c)}, std::move(mesh)});
  return parts;
}

}  // namespace murosimf
