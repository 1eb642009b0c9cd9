#include "murosimf/render/gl/gl_meshes.h"

#include <cstddef>

namespace murosimf {

namespace {

/// Where the instances' numbers stand, for the vertex array and the buffer that are bound.
void pointInstances(std::size_t first) {
  constexpr std::size_t kStride = sizeof(MeshInstance);
  const std::size_t begin = first * kStride;
  for (GLuint row = 0; row < 3; ++row)
    pointFloats(2 + row, 4, kStride, begin + offsetof(MeshInstance, X_WM) + 16U * row);
  pointFloats(5, 4, kStride, begin + offsetof(MeshInstance, tint));
  glEnableVertexAttribArray(6);
  glVertexAttribIPointer(6, 1, GL_UNSIGNED_INT, kStride,
                         reinterpret_cast<const void*>(begin + offsetof(MeshInstance, id)));  // NOLINT
  for (GLuint place = 2; place <= 6; ++place) glVertexAttribDivisor(place, 1);
}

}  // namespace

void pointFloats(GLuint place, GLint numbers, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));  // NOLINT: an offset, as OpenGL wants it
}

void GlMeshes::upload(const MeshLibrary& meshes) {
  for (int number = static_cast<int>(meshes_.size()); number < meshes.size(); ++number) {
    const Mesh& mesh = meshes[number];
    GpuMesh& there = meshes_.emplace_back();
    there.count = static_cast<GLsizei>(mesh.indices.size());
    glBindVertexArray(there.array.name());
    fillBuffer(GL_ARRAY_BUFFER, there.vertices, mesh.vertices, GL_STATIC_DRAW);
    pointFloats(0, 3, sizeof(MeshVertex), offsetof(MeshVertex, position));
    pointFloats(1, 3, sizeof(MeshVertex), offsetof(MeshVertex, normal));
    fillBuffer(GL_ELEMENT_ARRAY_BUFFER, there.indices, mesh.indices, GL_STATIC_DRAW);
  }
}

void GlMeshes::draw(const std::vector<std::vector<MeshInstance>>& instances) {
  all_.clear();
  for (const auto& of_mesh : instances) all_.insert(all_.end(), of_mesh.begin(), of_mesh.end());
  if (all_.empty()) return;
  fillBuffer(GL_ARRAY_BUFFER, instances_, all_, GL_STREAM_DRAW);
  std::size_t first = 0;
  for (std::size_t number = 0; number < instances.size(); ++number) {
    if (instances[number].empty()) continue;
    glBindVertexArray(meshes_[number].array.name());
    pointInstances(first);
    glDrawElementsInstanced(GL_TRIANGLES, meshes_[number].count, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(instances[number].size()));
    first += instances[number].size();
  }
}

}  // namespace murosimf
