#pragma once

/// @file A pair of shaders, compiled and linked.

#include <epoxy/gl.h>

#include <array>

namespace murosimf {

/// A matrix as shaders take it: sixteen numbers, row by row.
using GlMatrix = std::array<float, 16>;

class GlProgram {
 public:
  /// @throws std::runtime_error with the driver's words: a fault of ours
  GlProgram(const char* vertex_shader, const char* fragment_shader);
  ~GlProgram() { glDeleteProgram(name_); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { glUseProgram(name_); }
  // Of the program in use:
  void set(const char* uniform, const GlMatrix& value) const;
  void set(const char* uniform, const std::array<float, 2>& value) const;
  void set(const char* uniform, const std::array<float, 3>& value) const;
  void set(const char* uniform, const std::array<float, 4>& value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, unsigned value) const;

 private:
  GLint place(const char* uniform) const { return glGetUniformLocation(name_, uniform); }
  GLuint name_;
};

}  // namespace murosimf
