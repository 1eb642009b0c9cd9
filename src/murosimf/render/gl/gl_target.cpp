#include "murosimf/render/gl/gl_target.h"

#include <algorithm>
#include <stdexcept>

namespace murosimf {

namespace {

void checkComplete(const char* what) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  throw std::runtime_error(std::string("OpenGL cannot draw into ") + what);
}

void attach(const GlRenderbuffer& buffer, GLenum place, GLenum format, int width, int height, int samples) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
}

int mostSamples() {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  return most;
}

}  // namespace

void readColours(int width, int height, Picture& picture) {
  picture.has_depth = picture.has_label = false;
  picture.resize(width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
  const auto row = static_cast<std::ptrdiff_t>(3 * width);
  for (int v = 0; v < height / 2; ++v) {
    std::swap_ranges(picture.rgb.begin() + v * row, picture.rgb.begin() + (v + 1) * row,
                     picture.rgb.begin() + (height - 1 - v) * row);
  }
}

GlColourTarget::GlColourTarget(int width, int height, int samples)
    : width_(width), height_(height), samples_(std::clamp(samples, 1, mostSamples())) {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  attach(colours_, GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, samples_);
  attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, samples_);
  checkComplete("a picture with samples");
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  checkComplete("a texture");
}

void GlColourTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  glViewport(0, 0, width_, height_);
}

GLuint GlColourTarget::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return texture_.name();
}

void GlColourTarget::read(Picture& picture) const {
  resolve();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
  readColours(width_, height_, picture);
}

GlLabelTarget::GlLabelTarget(int width, int height) : width_(width), height_(height) {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  attach(labels_, GL_COLOR_ATTACHMENT0, GL_R32UI, width, height, 1);
  attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, 1);
  checkComplete("labels");
}

void GlLabelTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  glViewport(0, 0, width_, height_);
}

void GlLabelTarget::read(std::vector<std::uint32_t>& labels) const {
  const auto row = static_cast<std::size_t>(width_);
  labels.resize(row * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  for (int v = 0; v < height_; ++v) {
    glReadPixels(0, height_ - 1 - v, width_, 1, GL_RED_INTEGER, GL_UNSIGNED_INT,
                 labels.data() + static_cast<std::size_t>(v) * row);
  }
}

GlLabelTarget::Seen GlLabelTarget::at(int u, int v) const {
  Seen seen;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  glReadPixels(u, height_ - 1 - v, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &seen.label);
  glReadPixels(u, height_ - 1 - v, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &seen.depth);
  return seen;
}

}  // namespace murosimf
