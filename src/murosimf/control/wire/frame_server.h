#pragma once

/// @file Serves clients that send and get frames over TCP (frame_parser.h), on one thread of its own for all ports.
///
/// A port takes a client when it has a free channel; others wait in the system's queue. All sockets are non-blocking:
/// whatever a client does or does not do, the thread goes on with the others.

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/control/wire/frame_channel.h"
#include "murosimf/control/wire/tcp_socket.h"

namespace murosimf {

struct FramePort {
  std::string host = "127.0.0.1";                    ///< to listen on
  int port = 0;                                      ///< 0: the system chooses
  std::vector<std::string> allowed = {"127.0.0.1"};  ///< hosts that clients may come from
  int backlog = 8;
  /// Sent as they are, before any frame: to a client that is taken, and to one whose host is not allowed.
  std::string welcome, refusal;
  /// The channel of the next client; null: none is free now. Thread of the sockets.
  std::function<std::shared_ptr<FrameChannel>()> free_channel;
};

class FrameServer {
 public:
  FrameServer();
  ~FrameServer();
  FrameServer(const FrameServer&) = delete;
  FrameServer& operator=(const FrameServer&) = delete;

  /// Any thread. @returns the port's number. @throws std::system_error, std::invalid_argument as listenTcp() does
  int listen(FramePort port);
  /// Looks at what changed in a channel or among free channels. Any thread; never waits.
  void wake() const;
  /// Clients whose host was not allowed.
  long refusedClients() const { return refused_; }

 private:
  struct Listener;
  struct Connection;
  void serve();
  void adoptListeners();
  void waitForEvents();
  void acceptClient(Listener& listener);

  FileDescriptor wake_;
  std::mutex mutex_;  // of new_listeners_
  std::vector<std::unique_ptr<Listener>> new_listeners_;
  std::vector<std::unique_ptr<Listener>> listeners_;      // the thread's
  std::vector<std::unique_ptr<Connection>> connections_;  // the thread's
  std::atomic<bool> ends_{false};
  std::atomic<long> refused_{0};
  std::thread thread_;
};

}  // namespace murosimf
