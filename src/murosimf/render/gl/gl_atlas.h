#pragma once

/// @file One framebuffer for the pictures of several cameras, and how they come back while the next are drawn.
///
/// Pictures stand one below the other, so that each is one piece of memory where all are of one width. All come back by
/// one transfer of colours, one of labels, one of depths, into one of two sets of buffers; a fence tells when it is
/// done.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/picture.h"
#include "murosimf/algorithms/shape.h"
#include "murosimf/render/gl/gl_object.h"

namespace murosimf {

struct PictureSize {
  int width = 0, height = 0;  ///< [px]
};

class GlAtlas {
 public:
  static constexpr int kUnderWay = 2;

  /// With room for these. @throws std::invalid_argument when there is none, or more than the card can hold in one
  explicit GlAtlas(const std::vector<PictureSize>& sizes);
  ~GlAtlas();
  GlAtlas(const GlAtlas&) = delete;
  GlAtlas& operator=(const GlAtlas&) = delete;

  /// The next pictures have these sizes. @throws std::invalid_argument where there is not the room for them
  void arrange(const std::vector<PictureSize>& sizes);
  /// Begins new pictures: all of them sky, at once, since to clear them one by one costs more.
  void clear(const Colour& sky);
  /// Drawing goes into this picture from now on. @returns the row at which it begins
  int bind(std::size_t picture);
  /// Lets what has been drawn come back; depths only if told. @throws std::logic_error when two transfers are under way
  void beginReading(bool depths = true);
  /// Waits for the oldest transfer and fills pictures in the order of its sizes; of a null, nothing. Colour is always
  /// filled, label where the picture wants it, depth likewise where it has come back. @throws std::logic_error when
  /// none is under way
  void finishReading(std::span<Picture* const> pictures);
  int underWay() const { return begun_ - finished_; }

 private:
  static constexpr std::size_t kKinds = 3;  // colour, label, depth
  struct Layout {
    std::vector<PictureSize> sizes;
    std::vector<int> first_rows;
    int height = 0;
  };
  struct Transfer {
    std::array<GlBuffer, kKinds> buffers;
    GLsync fence = nullptr;
    Layout layout;
    std::size_t kinds = kKinds;
  };
  void makeImages();
  void copy(const Layout& layout, std::size_t kind, const void* from, std::span<Picture* const> pictures) const;
  Transfer& transfer(int number) { return transfers_[static_cast<std::size_t>(number % kUnderWay)]; }

  int width_ = 0, height_ = 0;
  Layout layout_;
  GlFramebuffer drawn_;
  std::array<GlRenderbuffer, kKinds> images_;
  GlRenderbuffer depth_;
  std::array<Transfer, kUnderWay> transfers_;
  int begun_ = 0, finished_ = 0;
};

}  // namespace murosimf
