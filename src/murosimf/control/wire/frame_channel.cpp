#include "murosimf/control/wire/frame_channel.h"

#include <utility>

namespace murosimf {

namespace {

constexpr std::size_t kMostSpares = 4;

}  // namespace

bool FrameChannel::isConnected() const {
  const std::lock_guard lock(mutex_);
  return connected_;
}

long FrameChannel::connection() const {
  const std::lock_guard lock(mutex_);
  return counts_.connections;
}

void FrameChannel::send(FrameBytes&& frame) {
  {
    const std::lock_guard lock(mutex_);
    if (!connected_) return;
    bytes_to_send_ += frame.size();
    to_send_.push_back(std::move(frame));
    while (to_send_.size() > 2 && (to_send_.size() > limits_.most_sent || bytes_to_send_ > limits_.most_sent_bytes)) {
      bytes_to_send_ -= to_send_.front().size();
      keepSpare(std::move(to_send_.front()));
      to_send_.pop_front();
      ++counts_.dropped;
    }
  }
  if (wake_) wake_();
}

std::optional<FrameBytes> FrameChannel::receive() {
  std::optional<FrameBytes> frame;
  bool was_full = false;
  {
    const std::lock_guard lock(mutex_);
    if (received_.empty()) return std::nullopt;
    was_full = received_.size() >= limits_.most_received;
    frame = std::move(received_.front());
    received_.pop_front();
  }
  if (was_full && wake_) wake_();  // the client may be read again
  return frame;
}

bool FrameChannel::waitForFrame(std::chrono::steady_clock::time_point until) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, until, [&] { return !received_.empty() || !connected_; });
  return !received_.empty();
}

bool FrameChannel::waitForClient(std::chrono::steady_clock::time_point until) {
  std::unique_lock lock(mutex_);
  return changed_.wait_until(lock, until, [&] { return connected_; });
}

void FrameChannel::disconnect() {
  {
    const std::lock_guard lock(mutex_);
    end_wanted_ = connected_;
  }
  if (wake_) wake_();
}

ChannelCounts FrameChannel::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void FrameChannel::open() {
  const std::lock_guard lock(mutex_);
  connected_ = true, end_wanted_ = false;
  received_.clear();
  ++counts_.connections;
  changed_.notify_all();
}

void FrameChannel::close(const std::string& why) {
  const std::lock_guard lock(mutex_);
  connected_ = end_wanted_ = false;
  counts_.last_end = why;
  counts_.dropped += static_cast<long>(to_send_.size());
  to_send_.clear();
  bytes_to_send_ = 0;
  changed_.notify_all();
}

bool FrameChannel::hasRoom() const {
  const std::lock_guard lock(mutex_);
  return received_.size() < limits_.most_received;
}

void FrameChannel::deliver(FrameBytes&& frame) {
  const std::lock_guard lock(mutex_);
  counts_.bytes_received += frame.size();
  ++counts_.received;
  received_.push_back(std::move(frame));
  changed_.notify_all();
}

std::optional<FrameBytes> FrameChannel::nextToSend() {
  const std::lock_guard lock(mutex_);
  if (to_send_.empty()) return std::nullopt;
  std::optional<FrameBytes> frame = std::move(to_send_.front());
  to_send_.pop_front();
  bytes_to_send_ -= frame->size();
  return frame;
}

void FrameChannel::giveBack(FrameBytes&& frame) {
  const std::lock_guard lock(mutex_);
  counts_.bytes_sent += frame.size();
  ++counts_.sent;
  keepSpare(std::move(frame));
}

void FrameChannel::keepSpare(FrameBytes&& frame) {
  if (spares_.size() < kMostSpares) spares_.push_back(std::move(frame));
}

FrameBytes FrameChannel::spare() {
  const std::lock_guard lock(mutex_);
  if (spares_.empty()) return {};
  FrameBytes frame = std::move(spares_.back());
  spares_.pop_back();
  return frame;
}

bool FrameChannel::wantsEnd() const {
  const std::lock_guard lock(mutex_);
  return end_wanted_;
}

}  // namespace murosimf
