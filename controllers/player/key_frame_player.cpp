#include "key_frame_player.h"

namespace murosimf::controllers {

void KeyFramePlayer::start(int motion, const JointAngles& now) {
  motion_ = motion, frame_ = 0, time_ = elapsed_ = 0;
  from_ = angles_ = now;
}

const JointAngles& KeyFramePlayer::step(double dt) {
  if (!running()) return angles_;
  time_ += dt, elapsed_ += dt;
  while (time_ >= frames()[frame_].duration) {  // what is left of dt belongs to the next frame
    time_ -= frames()[frame_].duration;
    from_ = angles_ = frames()[frame_].angles;
    if (++frame_ == frames().size()) {
      motion_ = -1;
      return angles_;
    }
  }
  const KeyFrame& frame = frames()[frame_];
  const double u = time_ / frame.duration;
  const double way = frame.evenly ? u : u * u * (3 - 2 * u);
  for (std::size_t i = 0; i < angles_.size(); ++i) angles_[i] = from_[i] + way * (frame.angles[i] - from_[i]);
  return angles_;
}

double KeyFramePlayer::duration(int motion) const {
  double sum = 0;
  for (const KeyFrame& frame : motions_[static_cast<std::size_t>(motion)]) sum += frame.duration;
  return sum;
}

void KeyFramePlayer::archive(client::StateArchive& archive) {
  archive(motion_, frame_, time_, elapsed_, from_, angles_);
}

}  // namespace murosimf::controllers
