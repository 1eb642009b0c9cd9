#pragma once

/// @file A picture of the simulation as an image among widgets.

#include <imgui.h>

#include "murosimf/algorithms/picture.h"
#include "murosimf/render/gl/gl_object.h"

namespace murosimf {

class ShownPicture {
 public:
  /// Hands the picture's colours to the graphics card.
  void set(const Picture& picture) {
    width_ = picture.width, height_ = picture.height;
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width_, height_, 0, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  }
  bool empty() const { return width_ == 0; }
  /// An image of this width [px], its height in proportion.
  void draw(float width) const {
    const float height = width * static_cast<float>(height_) / static_cast<float>(width_);
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_.name())),
                 {width, height});  // NOLINT
  }

 private:
  GlTexture texture_;
  int width_ = 0, height_ = 0;
};

}  // namespace murosimf
