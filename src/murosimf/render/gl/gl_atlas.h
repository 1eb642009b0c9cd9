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

  /// @throws std::invalid_argument when there is no picture, or they are more than the card can hold in one
  explicit GlAtlas(std::vector<PictureSize> sizes);
  ~GlAtlas();
  GlAtlas(const GlAtlas&) = delete;
  GlAtlas& operator=(const GlAtlas&) = delete;

  /// Begins new pictures: all of them sky, at once, since to clear them one by one costs more.
  void clear(const Colour& sky);
  /// Drawing goes into this picture from now on. @returns the row at which it begins
  int bind(std::size_t picture);
  /// Lets what has been drawn come back. @throws std::logic_error when two transfers are under way already
  void beginReading();
  /// Waits for the oldest transfer and fills pictures in the order of the sizes; of a null, nothing. Colour is always
  /// filled, depth and label where the picture wants them. @throws std::logic_error when none is under way
  void finishReading(std::span<Picture* const> pictures);
  int underWay() const { return begun_ - finished_; }

 private:
  static constexpr std::size_t kKinds = 3;  // colour, label, depth
  struct Transfer {
    std::array<GlBuffer, kKinds> buffers;
    GLsync fence = nullptr;
  };
  void copy(std::size_t kind, const void* from, std::span<Picture* const> pictures) const;
  Transfer& transfer(int number) { return transfers_[static_cast<std::size_t>(number % kUnderWay)]; }

  std::vector<PictureSize> sizes_;
  std::vector<int> first_rows_;
  int width_ = 0, height_ = 0;
  GlFramebuffer drawn_;
  std::array<GlRenderbuffer, kKinds> images_;
  GlRenderbuffer depth_;
  std::array<Transfer, kUnderWay> transfers_;
  int begun_ = 0, finished_ = 0;
};

}  // namespace murosimf
