#pragma once

/// @file Memory of the graphics card to draw into, and how it comes back.

#include <cstdint>
#include <vector>

#include "murosimf/algorithms/picture.h"
#include "murosimf/render/gl/gl_object.h"

namespace murosimf {

/// Colours with depth, drawn with some samples a pixel.
class GlColourTarget {
 public:
  /// @param samples  1, or as many as the driver knows up to this
  GlColourTarget(int width, int height, int samples = 1);
  int width() const { return width_; }
  int height() const { return height_; }
  /// Drawing goes here from now on.
  void bind() const;
  /// One sample a pixel, as a texture to show elsewhere.
  GLuint resolve() const;
  /// Rows from the top, 3 bytes a pixel.
  void read(Picture& picture) const;

 private:
  int width_, height_, samples_;
  GlFramebuffer drawn_, resolved_;
  GlRenderbuffer colours_, depth_;
  GlTexture texture_;
};

/// A number and a depth a pixel.
class GlLabelTarget {
 public:
  GlLabelTarget(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  void bind() const;
  /// Numbers of all pixels, rows from the top.
  void read(std::vector<std::uint32_t>& labels) const;
  /// Number and depth (0 near, 1 far) of one pixel, row 0 on top.
  struct Seen {
    std::uint32_t label = 0;
    float depth = 1;
  };
  Seen at(int u, int v) const;

 private:
  int width_, height_;
  GlFramebuffer drawn_;
  GlRenderbuffer labels_, depth_;
};

/// What the framebuffer that is bound for reading shows, rows from the top.
void readColours(int width, int height, Picture& picture);

}  // namespace murosimf
