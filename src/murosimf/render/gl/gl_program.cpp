#include "murosimf/render/gl/gl_program.h"

#include <stdexcept>
#include <string>

namespace murosimf {

namespace {

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == 0) {
    std::array<char, 2048> words{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error(std::string("a shader does not compile: ") + words.data());
  }
  return shader;
}

}  // namespace

GlProgram::GlProgram(const char* vertex_shader, const char* fragment_shader) : name_(glCreateProgram()) {
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex_shader), compile(GL_FRAGMENT_SHADER, fragment_shader)}) {
    glAttachShader(name_, shader);
    glDeleteShader(shader);  // with the program
  }
  glLinkProgram(name_);
  GLint good = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &good);
  if (good == 0) {
    std::array<char, 2048> words{};
    glGetProgramInfoLog(name_, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error(std::string("shaders do not go together: ") + words.data());
  }
}

void GlProgram::set(const char* uniform, const GlMatrix& value) const {
  glUniformMatrix4fv(place(uniform), 1, GL_TRUE, value.data());
}
void GlProgram::set(const char* uniform, const std::array<float, 2>& value) const {
  glUniform2fv(place(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const std::array<float, 4>& value) const {
  glUniform4fv(place(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const std::array<float, 3>& value) const {
  glUniform3fv(place(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, float value) const { glUniform1f(place(uniform), value); }
void GlProgram::set(const char* uniform, int value) const { glUniform1i(place(uniform), value); }
void GlProgram::set(const char* uniform, unsigned value) const { glUniform1ui(place(uniform), value); }

}  // namespace murosimf
