#include "murosimf/modules/camera/picture_queue.h"

#include <utility>

namespace murosimf {

void PictureQueue::add(Picture& picture, long frame) {
  if (count_ == places_.size()) {
    first_ = (first_ + 1) % places_.size();
    --count_;
  }
  Place& place = at(count_++);
  std::swap(place.picture, picture);
  place.frame = frame;
}

long PictureQueue::next(long frame, Picture& picture) {
  if (count_ == 0 || at(0).frame + latency_ > frame) return -1;
  Place& place = at(0);
  std::swap(place.picture, picture);
  first_ = (first_ + 1) % places_.size();
  --count_;
  return place.frame;
}

void PictureQueue::archive(StateArchive& archive) {
  archive(count_);
  if (archive.loading()) first_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    auto& [picture, frame] = at(i);
    archive(picture.width, picture.height, picture.rgb, picture.depth, picture.label, frame);
  }
}

}  // namespace murosimf
