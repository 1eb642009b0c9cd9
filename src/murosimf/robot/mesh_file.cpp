#include "murosimf/robot/mesh_file.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <tuple>

#include "murosimf/robot/checks.h"

namespace murosimf {
namespace {

constexpr std::uintmax_t kLargestFile = 64U << 20U;

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string fileProblem(const std::filesystem::path& file) {
  const std::string ending = lowerCase(file.extension().string());
  if (ending != ".stl" && ending != ".obj") return "is no mesh that can be read, expected a file .stl or .obj";
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault)) return "is not a file";
  const std::uintmax_t size = std::filesystem::file_size(file, fault);
  if (fault) return "cannot be read";
  if (size > kLargestFile) return fmt::format("has {} bytes, expected at most {}", size, kLargestFile);
  return "";
}

void addCorners(const aiMesh& mesh, std::vector<Vector3>& points) {
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 3) continue;
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      const aiVector3D& p = mesh.mVertices[face.mIndices[k]];
      points.push_back({p.x, p.y, p.z});
    }
  }
}

}  // namespace

MeshPoints readMeshPoints(const std::filesystem::path& file) {
  MeshPoints read;
  read.problem = fileProblem(file);
  if (!read.problem.empty()) return read;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (scene == nullptr) {
    read.problem = "cannot be read: " + quoted(importer.GetErrorString());
    return read;
  }
  std::vector<Vector3>& points = read.points;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) addCorners(*scene->mMeshes[i], points);
  if (points.empty()) read.problem = "holds no triangles";
  if (!std::all_of(points.begin(), points.end(), [](const Vector3& p) { return std::isfinite(squaredNorm(p)); })) {
    read.problem = "holds a coordinate that is no number or too large";
    points.clear();
  }
  std::sort(points.begin(), points.end(),
            [](const Vector3& a, const Vector3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return read;
}

}  // namespace murosimf
