#include "murosimf/control/wire/frame_server.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "murosimf/control/wire/frame_parser.h"

namespace murosimf {

namespace {

// A client that is cut off may come again at once, and again: no port takes more than one in this time.
constexpr std::chrono::milliseconds kBetweenClients{2};
constexpr std::size_t kReadAtOnce = 64 * 1024;  // so that no client keeps the thread from the others [bytes]

bool wouldBlock() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

struct FrameServer::Listener {
  FramePort port;
  HostList allowed;
  FileDescriptor socket;
  std::shared_ptr<FrameChannel> channel;  // for the next client
  std::chrono::steady_clock::time_point rests_until;

  bool rests() const { return std::chrono::steady_clock::now() < rests_until; }
  void rest() { rests_until = std::chrono::steady_clock::now() + kBetweenClients; }
};

/// One client: what has come but is no frame yet, and what is leaving.
struct FrameServer::Connection {
  FileDescriptor socket;
  std::shared_ptr<FrameChannel> channel;
  FrameParser parser;
  std::vector<std::uint8_t> left_over;  // read, but the channel had no room
  std::string greeting;
  std::optional<FrameBytes> leaving;
  std::array<std::uint8_t, FrameParser::kHeader> header{};
  std::size_t sent = 0;  // of greeting, or of header and frame
  std::string end;       // why it is over; empty: it is not

  Connection(FileDescriptor s, std::shared_ptr<FrameChannel> c, std::string welcome)
      : socket(std::move(s)),
        channel(std::move(c)),
        parser(channel->limits().largest_frame),
        greeting(std::move(welcome)) {}

  short events() const {
    const bool reads = left_over.empty() && channel->hasRoom();
    const bool writes = !greeting.empty() || leaving.has_value();
    return static_cast<short>((reads ? POLLIN : 0) | (writes ? POLLOUT : 0));
  }

  void take(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty() && channel->hasRoom()) {
      if (parser.take(bytes)) channel->deliver(std::move(parser.frame()));
    }
    if (parser.isLost())
      end = fmt::format("announced a frame of {} bytes, expected at most {}", parser.announced(),
                        channel->limits().largest_frame);
    left_over.assign(bytes.begin(), bytes.end());
  }

  void read() {
    if (!left_over.empty()) {
      const std::vector<std::uint8_t> bytes = std::exchange(left_over, {});
      take(bytes);
    }
    if (!end.empty() || !left_over.empty() || !channel->hasRoom()) return;
    std::array<std::uint8_t, kReadAtOnce> bytes;
    const ssize_t count = ::recv(socket.number(), bytes.data(), bytes.size(), 0);
    if (count > 0) {
      take(std::span(bytes).first(static_cast<std::size_t>(count)));
    } else if (count == 0) {
      end = "closed by the client";
    } else if (!wouldBlock()) {
      end = std::generic_category().message(errno);
    }
  }

  /// @returns true when all of it has left
  bool push(const std::uint8_t* bytes, std::size_t size, std::size_t offset) {
    while (sent < offset + size) {
      const std::size_t done = sent - offset;
      const ssize_t count = ::send(socket.number(), bytes + done, size - done, MSG_NOSIGNAL);
      if (count < 0) {
        if (!wouldBlock()) end = std::generic_category().message(errno);
        return false;
      }
      sent += static_cast<std::size_t>(count);
    }
    return true;
  }

  bool pushGreeting() {
    const std::vector<std::uint8_t> bytes(greeting.begin(), greeting.end());
    if (!push(bytes.data(), bytes.size(), 0)) return false;
    greeting.clear();
    return true;
  }

  void write() {
    if (!greeting.empty() && !pushGreeting()) return;
    for (;;) {
      if (!leaving) {
        leaving = channel->nextToSend();
        if (!leaving) return;
        writeFrameHeader(leaving->size(), header.data());
        sent = 0;
      }
      if (sent < header.size() && !push(header.data(), header.size(), 0)) return;
      if (!push(leaving->data(), leaving->size(), header.size())) return;
      channel->giveBack(std::move(*leaving));
      leaving.reset();
    }
  }

  void serve(short happened) {
    // What a client that has gone still wanted is lost where there is no room for it.
    if ((happened & (POLLERR | POLLNVAL)) != 0 || ((happened & POLLHUP) != 0 && !channel->hasRoom()))
      end = "connection lost";
    if (end.empty() && channel->wantsEnd()) {
      write();  // what fits: the reason may be among it
      end = "ended by the simulator";
    }
    if (end.empty() && ((happened & (POLLIN | POLLHUP)) != 0 || !left_over.empty())) read();
    if (end.empty()) write();
  }
};

FrameServer::FrameServer()
    : wake_(checkedCall(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC), "cannot make an event")),
      thread_([this] { serve(); }) {}

FrameServer::~FrameServer() {
  ends_ = true;
  wake();
  thread_.join();
}

void FrameServer::wake() const {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_.number(), &one, sizeof one);  // full: it is awake anyway
}

int FrameServer::listen(FramePort port) {
  auto listener = std::make_unique<Listener>();
  listener->socket = listenTcp(port.host, port.port, port.backlog);
  listener->allowed = HostList(port.allowed);
  listener->port = std::move(port);
  const int number = portOf(listener->socket);
  {
    const std::lock_guard lock(mutex_);
    new_listeners_.push_back(std::move(listener));
  }
  wake();
  return number;
}

void FrameServer::serve() {
  while (!ends_) {
    adoptListeners();
    waitForEvents();
  }
  for (const auto& connection : connections_) connection->channel->close("the simulator ended");
}

void FrameServer::adoptListeners() {
  const std::lock_guard lock(mutex_);
  for (auto& listener : new_listeners_) listeners_.push_back(std::move(listener));
  new_listeners_.clear();
}

void FrameServer::waitForEvents() {
  std::vector<pollfd> polled{{wake_.number(), POLLIN, 0}};
  bool rest = false;
  for (const auto& listener : listeners_) {
    if (listener->channel == nullptr) listener->channel = listener->port.free_channel();
    const bool takes = listener->channel != nullptr && !listener->rests();
    rest = rest || (listener->channel != nullptr && !takes);
    polled.push_back({listener->socket.number(), static_cast<short>(takes ? POLLIN : 0), 0});
  }
  for (const auto& connection : connections_) polled.push_back({connection->socket.number(), connection->events(), 0});
  const int patience = rest ? static_cast<int>(kBetweenClients.count()) : -1;
  if (::poll(polled.data(), polled.size(), patience) < 0) return;
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t read = ::read(wake_.number(), &count, sizeof count);
  const std::size_t first = 1 + listeners_.size(), old = connections_.size();
  for (std::size_t i = 0; i < listeners_.size(); ++i) {
    if ((polled[1 + i].revents & POLLIN) != 0) acceptClient(*listeners_[i]);
  }
  for (std::size_t i = 0; i < old; ++i) connections_[i]->serve(polled[first + i].revents);
  std::erase_if(connections_, [](const std::unique_ptr<Connection>& connection) {
    if (!connection->end.empty()) connection->channel->close(connection->end);
    return !connection->end.empty();
  });
}

void FrameServer::acceptClient(Listener& listener) {
  AcceptedClient client = acceptTcp(listener.socket);
  if (!client.socket.isOpen()) return;
  listener.rest();
  if (!listener.allowed.allows(client.address)) {
    ++refused_;
    ::send(client.socket.number(), listener.port.refusal.data(), listener.port.refusal.size(), MSG_NOSIGNAL);
    return;
  }
  std::shared_ptr<FrameChannel> channel = std::exchange(listener.channel, nullptr);
  channel->setWake([this] { wake(); });
  connections_.push_back(std::make_unique<Connection>(std::move(client.socket), channel, listener.port.welcome));
  channel->open();
  connections_.back()->write();
}

}  // namespace murosimf
