#pragma once

/// @file What a sensor measured, on its way to control software: it arrives some frames after it was taken.
///
/// A ring of places that are all made in the beginning. Contents are exchanged, never copied, so that nothing is
/// allocated while frames run as long as contents keep their size. Cost of a call: one exchange.

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "murosimf/math/state_archive.h"

namespace murosimf {

template <class Contents>
class ArrivalQueue {
 public:
  /// Has no places: a queue that is to be replaced.
  ArrivalQueue() = default;
  /// @param delay  [frames] @param most  contents on their way at the same time, > 0 @param memory  what every place
  /// gives away first
  ArrivalQueue(long delay, std::size_t most, const Contents& memory = {}) : delay_(delay), places_(most, {memory, 0}) {}

  /// Takes what was measured at the end of a frame, and gives older memory for it. Where no place is left, the oldest
  /// contents on their way are lost.
  void add(Contents& contents, long frame) {
    if (count_ == places_.size()) dropOldest();
    Place& place = at(count_++);
    std::swap(place.contents, contents);
    place.frame = frame;
  }

  /// Hands over the oldest contents that have arrived by the end of this frame, in exchange for memory.
  /// @return the frame of which they are; nothing where none have arrived
  std::optional<long> next(long frame, Contents& contents) {
    if (count_ == 0 || at(0).frame + delay_ > frame) return std::nullopt;
    Place& place = at(0);
    std::swap(place.contents, contents);
    dropOldest();
    return place.frame;
  }

  /// Keeps what is on its way, oldest first, by archiveOne(contents, frame).
  /// @throws std::runtime_error when more was kept than there are places for.
  template <class ArchiveOne>
  void archive(StateArchive& archive, const ArchiveOne& archiveOne) {
    archive(count_);
    if (count_ > places_.size()) throw std::runtime_error("state archive: more measurements on their way than places");
    if (archive.loading()) first_ = 0;
    for (std::size_t i = 0; i < count_; ++i) archiveOne(at(i).contents, at(i).frame);
  }

 private:
  struct Place {
    Contents contents;
    long frame = 0;
  };
  Place& at(std::size_t i) { return places_[(first_ + i) % places_.size()]; }
  void dropOldest() {
    first_ = (first_ + 1) % places_.size();
    --count_;
  }

  long delay_ = 0;
  std::vector<Place> places_;
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace murosimf
