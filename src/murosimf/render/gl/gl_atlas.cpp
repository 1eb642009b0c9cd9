#include "murosimf/render/gl/gl_atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace murosimf {

namespace {

/// How a kind of picture is kept, and how it comes back.
struct Format {
  GLenum kept, order, number;
  GLsizeiptr bytes;  // a pixel
};
constexpr std::array<Format, 3> kFormats{{{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
                                          {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2},
                                          {GL_R32F, GL_RED, GL_FLOAT, 4}}};
constexpr GLuint64 kPatience = 10'000'000'000;  // [ns]

void attach(const GlRenderbuffer& buffer, GLenum place, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
}

/// Four bytes a pixel into three. A pixel is written with one byte too many, which the next one overwrites.
void copyColours(const std::uint8_t* from, std::size_t pixels, std::uint8_t* to) {
  for (std::size_t i = 0; i + 1 < pixels; ++i) std::memcpy(to + 3 * i, from + 4 * i, 4);
  std::memcpy(to + 3 * (pixels - 1), from + 4 * (pixels - 1), 3);
}

}  // namespace

GlAtlas::GlAtlas(const std::vector<PictureSize>& sizes) {
  for (const PictureSize& size : sizes) width_ = std::max(width_, size.width), height_ += size.height;
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (sizes.empty() || width_ > most || height_ > most)
    throw std::invalid_argument(fmt::format("{} pictures, {} x {} pixels together, expected some and at most {} x {}",
                                            sizes.size(), width_, height_, most, most));
  makeImages();
  arrange(sizes);
}

void GlAtlas::makeImages() {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  std::array<GLenum, kKinds> places{};
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    places[kind] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(kind);
    attach(images_[kind], places[kind], kFormats[kind].kept, width_, height_);
  }
  attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width_, height_);
  glDrawBuffers(kKinds, places.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("OpenGL cannot draw colours, labels and depths at once");
  for (Transfer& t : transfers_)
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      glBindBuffer(GL_PIXEL_PACK_BUFFER, t.buffers[kind].name());
      glBufferData(GL_PIXEL_PACK_BUFFER, kFormats[kind].bytes * width_ * height_, nullptr, GL_STREAM_READ);
    }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void GlAtlas::arrange(const std::vector<PictureSize>& sizes) {
  int width = 0, height = 0;
  layout_.sizes = sizes;
  layout_.first_rows.clear();
  for (const PictureSize& size : sizes) {
    layout_.first_rows.push_back(height);
    width = std::max(width, size.width), height += size.height;
  }
  layout_.height = height;
  if (width > width_ || height > height_)
    throw std::invalid_argument(fmt::format("{} pictures, {} x {} pixels together, where there is room for {} x {}",
                                            sizes.size(), width, height, width_, height_));
}

GlAtlas::~GlAtlas() {
  for (const Transfer& t : transfers_)
    if (t.fence != nullptr) glDeleteSync(t.fence);
}

void GlAtlas::clear(const Colour& sky) {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  const GLfloat colour[] = {sky.red, sky.green, sky.blue, 1}, far[] = {INFINITY, 0, 0, 0}, back = 1;
  const GLuint label[] = {kSkyLabel, 0, 0, 0};
  glDepthMask(GL_TRUE);
  const bool part = layout_.height < height_;
  glScissor(0, 0, width_, layout_.height);
  if (part) glEnable(GL_SCISSOR_TEST);
  glClearBufferfv(GL_COLOR, 0, colour);
  glClearBufferuiv(GL_COLOR, 1, label);
  glClearBufferfv(GL_COLOR, 2, far);
  glClearBufferfv(GL_DEPTH, 0, &back);
  glDisable(GL_SCISSOR_TEST);
}

int GlAtlas::bind(std::size_t picture) {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  const PictureSize& size = layout_.sizes[picture];
  glViewport(0, layout_.first_rows[picture], size.width, size.height);
  return layout_.first_rows[picture];
}

void GlAtlas::beginReading(bool depths) {
  if (underWay() == kUnderWay) throw std::logic_error("two transfers are under way already");
  Transfer& t = transfer(begun_++);
  t.layout = layout_;
  t.kinds = depths ? kKinds : kKinds - 1;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (std::size_t kind = 0; kind < t.kinds; ++kind) {
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(kind));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, t.buffers[kind].name());
    glReadPixels(0, 0, width_, layout_.height, kFormats[kind].order, kFormats[kind].number, nullptr);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  t.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

void GlAtlas::copy(const Layout& layout, std::size_t kind, const void* from, std::span<Picture* const> pictures) const {
  const auto bytes = static_cast<std::size_t>(kFormats[kind].bytes), stride = bytes * static_cast<std::size_t>(width_);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Picture* const p = pictures[i];
    if (p == nullptr) continue;
    const std::uint8_t* row =
        static_cast<const std::uint8_t*>(from) + stride * static_cast<std::size_t>(layout.first_rows[i]);
    const auto width = static_cast<std::size_t>(p->width);
    for (std::size_t v = 0; v < static_cast<std::size_t>(p->height); ++v, row += stride) {
      if (kind == 0) copyColours(row, width, p->rgb.data() + 3 * v * width);
      if (kind == 1 && p->has_label) std::memcpy(p->label.data() + v * width, row, bytes * width);
      if (kind == 2 && p->has_depth) std::memcpy(p->depth.data() + v * width, row, bytes * width);
    }
  }
}

void GlAtlas::finishReading(std::span<Picture* const> pictures) {
  if (underWay() == 0) throw std::logic_error("no transfer is under way");
  Transfer& t = transfer(finished_++);
  const std::vector<PictureSize>& sizes = t.layout.sizes;
  if (pictures.size() != sizes.size()) throw std::logic_error("expected as many pictures as were drawn");
  const GLenum state = glClientWaitSync(t.fence, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience);
  glDeleteSync(t.fence);
  t.fence = nullptr;
  if (state == GL_TIMEOUT_EXPIRED || state == GL_WAIT_FAILED) throw std::runtime_error("OpenGL draws no picture");
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (pictures[i] != nullptr) pictures[i]->resize(sizes[i].width, sizes[i].height);
  for (std::size_t kind = 0; kind < t.kinds; ++kind) {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, t.buffers[kind].name());
    const GLsizeiptr bytes = kFormats[kind].bytes * width_ * t.layout.height;
    const void* const there = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (there == nullptr) throw std::runtime_error("OpenGL gives no picture back");
    copy(t.layout, kind, there, pictures);
    glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

}  // namespace murosimf
