// The part of ServoBus that runs on its own thread.

#include <poll.h>
#include <sys/eventfd.h>

#include <array>
#include <chrono>
#include <cmath>

#include "murosimf/control/servo_bus/servo_bus.h"

namespace murosimf::servo_bus {

namespace {

constexpr int kUnfinishedTime = 100;    // [ms] after which a packet that was begun will not be finished
constexpr double kBitsPerByte = 10;     // with start and stop bit
constexpr double kShortestRest = 2e-5;  // [s] that is worth waiting for

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

/// Waits, or until it is to end. @returns whether it is to go on
bool ServoBus::rest(double seconds) const {
  if (seconds > kShortestRest) {
    std::array<pollfd, 1> wait = {{{alarm_.number(), POLLIN, 0}}};
    timespec time{};
    time.tv_sec = static_cast<time_t>(std::floor(seconds));
    time.tv_nsec = static_cast<long>((seconds - std::floor(seconds)) * 1e9);
    ::ppoll(wait.data(), wait.size(), &time, nullptr);
  }
  return !ends_;
}

void ServoBus::serve() {
  PacketReader reader(settings_.protocol);
  std::array<pollfd, 2> wait = {{{alarm_.number(), POLLIN, 0}, {terminal_->number(), POLLIN, 0}}};
  Bytes bytes;
  double ready = 0;  // when the wire is free again
  while (!ends_) {
    const bool unfinished = reader.pending() > 0;
    const int events = ::poll(wait.data(), open_ ? 2 : 1, unfinished ? kUnfinishedTime : -1);
    eventfd_t value = 0;
    if (wait[0].revents != 0) ::eventfd_read(alarm_.number(), &value);
    bytes.clear();
    if (open_) terminal_->read(bytes);
    if (settings_.baud_rate > 0) {
      ready = std::max(ready, now()) + kBitsPerByte * static_cast<double>(bytes.size()) / settings_.baud_rate;
    }
    reader.take(bytes);
    if (events == 0) reader.giveUp();
    for (auto packet = reader.next(); packet && !ends_; packet = reader.next()) follow(*packet, ready);
  }
}

void ServoBus::follow(const InstructionPacket& packet, double& ready) {
  step_asks_.wait(true);
  std::vector<Answer> answers;
  {
    const std::lock_guard lock(mutex_);
    const std::uint64_t before = goalWrites();
    answers = bus_->handle(packet);
    ++(packet.damaged ? counts_.damaged : counts_.packets);
    if (goalWrites() != before) goals_written_.notify_all();
  }
  for (const Answer& answer : answers) send(answer, ready);
}

void ServoBus::send(const Answer& answer, double& ready) {
  if (settings_.baud_rate > 0) {
    ready += answer.delay + kBitsPerByte * static_cast<double>(answer.bytes.size()) / settings_.baud_rate;
    if (!rest(ready - now())) return;
  }
  const std::size_t written = terminal_->write(answer.bytes);
  if (written == answer.bytes.size()) return;
  const std::lock_guard lock(mutex_);
  counts_.lost_bytes += answer.bytes.size() - written;
}

}  // namespace murosimf::servo_bus
