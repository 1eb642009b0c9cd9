#include "murosimf/control/game_controller/game_link.h"

#include <poll.h>
#include <sys/eventfd.h>

namespace murosimf::game_controller {

namespace {

constexpr std::size_t kMostWaiting = 64;      // packets
constexpr std::size_t kMostRobots = 64;       // of which something is kept
constexpr std::size_t kLargestPacket = 1500;  // [bytes]
constexpr int kRest = 5;                      // between two looks for packets that wait to leave [ms]
constexpr int kHeardAtOnce = 100;             // packets, so that a flood does not keep us from sending

}  // namespace

GameLink::GameLink(const GameLinkSettings& settings)
    : to_(udpAddress(settings.host, settings.port)),
      allowed_(settings.allowed),
      socket_(openUdp(settings.listen_host, settings.return_port, settings.broadcast)),
      wake_(checkedCall(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC), "cannot make an event")),
      return_port_(portOf(socket_)),
      thread_([this] { serve(); }) {}

GameLink::~GameLink() {
  ends_ = true;
  wake();
  thread_.join();
}

void GameLink::wake() const {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_.number(), &one, sizeof one);
}

void GameLink::send(Bytes&& packet) {
  const std::lock_guard lock(mutex_);
  if (to_send_.size() == kMostWaiting) to_send_.pop_front(), ++counts_.dropped;
  to_send_.push_back(std::move(packet));
}

void GameLink::serve() {
  while (!ends_) {
    std::array<pollfd, 2> polled{{{wake_.number(), POLLIN, 0}, {socket_.number(), POLLIN, 0}}};
    if (::poll(polled.data(), polled.size(), kRest) < 0) continue;
    std::uint64_t count = 0;
    [[maybe_unused]] const ssize_t read = ::read(wake_.number(), &count, sizeof count);
    sendAll();
    hearAll();
  }
  sendAll();
}

void GameLink::sendAll() {
  for (;;) {
    Bytes packet;
    {
      const std::lock_guard lock(mutex_);
      if (to_send_.empty()) return;
      packet = std::move(to_send_.front());
      to_send_.pop_front();
    }
    const bool left = sendUdp(socket_, to_, packet);
    const std::lock_guard lock(mutex_);
    ++(left ? counts_.sent : counts_.dropped);
  }
}

void GameLink::hearAll() {
  Bytes bytes;
  UdpAddress from;
  for (int i = 0; i < kHeardAtOnce && receiveUdp(socket_, bytes, from, kLargestPacket); ++i) {
    const bool known = allowed_.allows(from.host);
    const std::lock_guard lock(mutex_);
    if (known) {
      hear(bytes);
    } else {
      ++counts_.strangers;
    }
  }
}

void GameLink::hear(std::span<const std::uint8_t> bytes) {
  std::string problem;
  std::optional<RobotStatus> status = decodeStatus(bytes, problem);
  if (!status && bytes.size() == 8) {
    problem.clear();
    if (const std::optional<RobotMessage> message = decodeMessage(bytes, problem))
      status = RobotStatus{message->player, message->team};
  }
  const bool known = status && robots_.contains({status->team, status->player});
  if (!status || (!known && robots_.size() >= kMostRobots)) {
    ++counts_.refused;
    counts_.last_problem = status ? "more than 64 robots" : problem;
    return;
  }
  ++counts_.heard;
  HeardRobot& robot = robots_[{status->team, status->player}];
  robot.status = *status;
  ++robot.packets;
}

std::map<std::pair<int, int>, HeardRobot> GameLink::robots() const {
  const std::lock_guard lock(mutex_);
  return robots_;
}

GameLinkCounts GameLink::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace murosimf::game_controller
