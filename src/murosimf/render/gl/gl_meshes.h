#pragma once

/// @file Meshes in the memory of the graphics card, and how many instances of them are drawn.

#include <deque>
#include <vector>

#include "murosimf/render/draw_list.h"
#include "murosimf/render/gl/gl_object.h"

namespace murosimf {

/// Where a number of a vertex stands, for the array and buffer that are bound.
void pointFloats(GLuint place, GLint numbers, std::size_t stride, std::size_t offset);

template <class T>
void fillBuffer(GLenum kind, const GlBuffer& buffer, const std::vector<T>& values, GLenum usage) {
  glBindBuffer(kind, buffer.name());
  glBufferData(kind, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), usage);
}

/// Places of a shader's input: 0 position, 1 normal, 2 to 4 rows of the map into the world, 5 tint, 6 id.
class GlMeshes {
 public:
  /// Adds what is new in the library.
  void upload(const MeshLibrary& meshes);
  /// One call a mesh, whatever the number of its instances. [mesh number]
  void draw(const std::vector<std::vector<MeshInstance>>& instances);

 private:
  struct GpuMesh {
    GlVertexArray array;
    GlBuffer vertices, indices;
    GLsizei count = 0;
  };
  std::deque<GpuMesh> meshes_;
  GlBuffer instances_;
  std::vector<MeshInstance> all_;
};

}  // namespace murosimf
