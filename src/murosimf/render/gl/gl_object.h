#pragma once

/// @file Owners of OpenGL's names: what a scope made, its end deletes. The context must be current at both.

#include <epoxy/gl.h>

#include <utility>

namespace murosimf {

/// `Kind` has create() -> GLuint and destroy(GLuint).
template <class Kind>
class GlObject {
 public:
  GlObject() : name_(Kind::create()) {}
  ~GlObject() {
    if (name_ != 0) Kind::destroy(name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept { return std::swap(name_, other.name_), *this; }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

#define MUROSIMF_GL_KIND(Name, generate, remove)           \
  struct Name##Kind {                                      \
    static GLuint create() {                               \
      GLuint name = 0;                                     \
      generate(1, &name);                                  \
      return name;                                         \
    }                                                      \
    static void destroy(GLuint name) { remove(1, &name); } \
  };                                                       \
  using Name = GlObject<Name##Kind>

MUROSIMF_GL_KIND(GlBuffer, glGenBuffers, glDeleteBuffers);
MUROSIMF_GL_KIND(GlVertexArray, glGenVertexArrays, glDeleteVertexArrays);
MUROSIMF_GL_KIND(GlTexture, glGenTextures, glDeleteTextures);
MUROSIMF_GL_KIND(GlFramebuffer, glGenFramebuffers, glDeleteFramebuffers);
MUROSIMF_GL_KIND(GlRenderbuffer, glGenRenderbuffers, glDeleteRenderbuffers);
#undef MUROSIMF_GL_KIND

}  // namespace murosimf
