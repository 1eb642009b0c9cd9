#include "murosimf/simulation/frame_history.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

FrameHistory::FrameHistory(Simulation& simulation, const FrameHistorySettings& settings)
    : simulation_(simulation),
      settings_(settings),
      interval_(std::max(1L, std::lround(settings.interval / simulation.frameLength()))),
      last_(simulation.frame()) {
  simulation_.start();
  keep();
}

void FrameHistory::keep() {
  StateArchive archive;
  simulation_.archive(archive);
  bytes_ += archive.bytes().size();
  checkpoints_.emplace(simulation_.frame(), archive.bytes());
  if (bytes_ > settings_.most_bytes) thin();
}

/// Every second one of the older half; the first one stays.
void FrameHistory::thin() {
  const std::size_t older = checkpoints_.size() / 2;
  auto next = std::next(checkpoints_.begin());
  for (std::size_t i = 1; i + 1 < older; i += 2) {
    bytes_ -= next->second.size();
    next = std::next(checkpoints_.erase(next));
  }
}

void FrameHistory::step() {
  askAgain();
  simulation_.step();
  const long frame = simulation_.frame();
  last_ = std::max(last_, frame);
  if (frame % interval_ == 0 && checkpoints_.count(frame) == 0) keep();
}

/// What was asked for in this frame when it ran before.
void FrameHistory::askAgain() {
  const auto [begin, end] = asked_.equal_range(simulation_.frame());
  for (auto it = begin; it != end; ++it) simulation_.interventions().request(it->first, it->second);
}

void FrameHistory::request(const Intervention& intervention) {
  forgetAfter(simulation_.frame());
  simulation_.interventions().check(intervention);
  asked_.emplace(simulation_.frame(), intervention);
}

void FrameHistory::forgetAfter(long frame) {
  for (auto it = checkpoints_.upper_bound(frame); it != checkpoints_.end(); it = checkpoints_.erase(it)) {
    bytes_ -= it->second.size();
  }
  asked_.erase(asked_.upper_bound(frame), asked_.end());
  last_ = frame;
}

/// The newest checkpoint that is not later.
void FrameHistory::load(long frame) {
  StateArchive archive(std::prev(checkpoints_.upper_bound(frame))->second);
  simulation_.archive(archive);
}

void FrameHistory::restore() {
  const long frame = simulation_.frame();
  load(frame);
  goTo(frame);
}

void FrameHistory::goTo(long frame) {
  frame = std::max(frame, firstFrame());
  if (frame < simulation_.frame()) load(frame);
  while (simulation_.frame() < frame) step();
}

}  // namespace murosimf
