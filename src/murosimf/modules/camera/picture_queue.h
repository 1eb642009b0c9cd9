#pragma once

/// @file Pictures on their way from a camera to its software: they arrive some frames after they were taken.

#include <vector>

#include "murosimf/algorithms/picture.h"
#include "murosimf/math/state_archive.h"

namespace murosimf {

class PictureQueue {
 public:
  /// @param latency  [frames] @param most  pictures that are on their way at the same time
  PictureQueue(long latency, std::size_t most) : latency_(latency), places_(most) {}

  /// Takes the contents of a picture that was taken at the end of this frame, and gives older memory for them.
  /// Where no place is left, the oldest picture on its way is lost.
  void add(Picture& picture, long frame);
  /// Hands over the oldest picture that has arrived by the end of this frame. @return its frame; -1: none has
  long next(long frame, Picture& picture);
  void archive(StateArchive& archive);

 private:
  struct Place {
    Picture picture;
    long frame = 0;
  };
  Place& at(std::size_t i) { return places_[(first_ + i) % places_.size()]; }

  long latency_;
  std::vector<Place> places_;  // a ring
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace murosimf
