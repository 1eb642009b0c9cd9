#pragma once

/// @file Owners of OpenGL's names: what a scope made, its end deletes. The context must be current at both.

#include <epoxy/gl.h>

#include <utility>

namespace murosimf {

/// `Kind` has create(GLuint*) and destroy(const GLuint*).
template <class Kind>
class GlObject {
 public:
  GlObject() { Kind::create(&name_); }
  ~GlObject() {
    if (name_ != 0) Kind::destroy(&name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept { return std::swap(name_, other.name_), *this; }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct GlBufferKind {
  static void create(GLuint* name) { glGenBuffers(1, name); }
  static void destroy(const GLuint* name) { glDeleteBuffers(1, name); }
};
struct GlVertexArrayKind {
  static void create(GLuint* name) { glGenVertexArrays(1, name); }
  static void destroy(const GLuint* name) { glDeleteVertexArrays(1, name); }
};
struct GlTextureKind {
  static void create(GLuint* name) { glGenTextures(1, name); }
  static void destroy(const GLuint* name) { glDeleteTextures(1, name); }
};
struct GlFramebufferKind {
  static void create(GLuint* name) { glGenFramebuffers(1, name); }
  static void destroy(const GLuint* name) { glDeleteFramebuffers(1, name); }
};
struct GlRenderbufferKind {
  static void create(GLuint* name) { glGenRenderbuffers(1, name); }
  static void destroy(const GLuint* name) { glDeleteRenderbuffers(1, name); }
};

using GlBuffer = GlObject<GlBufferKind>;
using GlVertexArray = GlObject<GlVertexArrayKind>;
using GlTexture = GlObject<GlTextureKind>;
using GlFramebuffer = GlObject<GlFramebufferKind>;
using GlRenderbuffer = GlObject<GlRenderbufferKind>;

}  // namespace murosimf
