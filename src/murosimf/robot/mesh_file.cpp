#include "murosimf/robot/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <optional>
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

/// The colour that a material names; nothing where the file has none and assimp fills in its own.
std::optional<Colour> colourOf(const aiScene& scene, const aiMesh& mesh) {
  if (mesh.mMaterialIndex >= scene.mNumMaterials) return std::nullopt;
  const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
  aiColor3D c;
  if (material.GetName() == aiString(AI_DEFAULT_MATERIAL_NAME) || material.GetName().length == 0 ||
      material.Get(AI_MATKEY_COLOR_DIFFUSE, c) != AI_SUCCESS)
    return std::nullopt;
  return Colour{std::clamp(c.r, 0.0F, 1.0F), std::clamp(c.g, 0.0F, 1.0F), std::clamp(c.b, 0.0F, 1.0F)};
}

/// Corners one by one, three a triangle.
void addTriangles(const aiScene& scene, const aiMesh& mesh, MeshFile& out, bool& coloured) {
  const std::optional<Colour> colour = colourOf(scene, mesh);
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;
    for (unsigned k = 0; k < 3; ++k) {
      const aiVector3D& p = mesh.mVertices[face.mIndices[k]];
      out.points.push_back({p.x, p.y, p.z});
    }
    out.colours.push_back(colour.value_or(Colour{}));
    coloured = coloured || colour.has_value();
  }
}

bool isBefore(const Vector3& a, const Vector3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// From three corners a triangle to each place once.
void joinCorners(MeshFile& file) {
  const std::vector<Vector3> all = file.points;
  std::sort(file.points.begin(), file.points.end(), isBefore);
  file.points.erase(std::unique(file.points.begin(), file.points.end()), file.points.end());
  const auto number = [&](const Vector3& p) {
    return static_cast<int>(std::lower_bound(file.points.begin(), file.points.end(), p, isBefore) -
                            file.points.begin());
  };
  for (std::size_t i = 0; i < all.size(); i += 3)
    file.triangles.push_back({number(all[i]), number(all[i + 1]), number(all[i + 2])});
}

}  // namespace

MeshFile readMeshFile(const std::filesystem::path& file) {
  MeshFile read;
  read.problem = fileProblem(file);
  if (!read.problem.empty()) return read;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (scene == nullptr) {
    read.problem = "cannot be read: " + quoted(importer.GetErrorString());
    return read;
  }
  const bool is_object = lowerCase(file.extension().string()) == ".obj";
  bool coloured = false;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) addTriangles(*scene, *scene->mMeshes[i], read, coloured);
  if (!coloured || !is_object) read.colours.clear();
  if (read.points.empty()) read.problem = "holds no triangles";
  if (!std::all_of(read.points.begin(), read.points.end(),
                   [](const Vector3& p) { return std::isfinite(squaredNorm(p)); })) {
    read = {};
    read.problem = "holds a coordinate that is no number or too large";
  }
  joinCorners(read);
  return read;
}

}  // namespace murosimf
