#pragma once

/// @file What lies between a client's connection and the program that speaks with it: two bounded queues of frames.
///
/// The one side is the thread of the sockets (FrameServer), the other a program's thread. Neither ever waits for the
/// other's system calls: the lock is held while pointers are moved, nothing else.
///   received  a client that sends faster than frames are taken is not read any further: its own socket fills up
///   sent      of a client that does not read, the oldest frames that have not begun to leave are dropped

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace murosimf {

using FrameBytes = std::vector<std::uint8_t>;

struct ChannelLimits {
  std::size_t largest_frame = 64 * 1024;   ///< that a client may send [bytes]
  std::size_t most_received = 32;          ///< frames that wait to be taken
  std::size_t most_sent = 64;              ///< frames that wait to leave, ...
  std::size_t most_sent_bytes = 16 << 20;  ///< ... and their bytes; two frames may wait whatever they have
};

struct ChannelCounts {
  long connections = 0, received = 0, sent = 0, dropped = 0;
  std::uint64_t bytes_received = 0, bytes_sent = 0;
  std::string last_end;  ///< why the last connection ended
};

class FrameChannel {
 public:
  explicit FrameChannel(const ChannelLimits& limits = {}) : limits_(limits) {}
  const ChannelLimits& limits() const { return limits_; }

  // The program's side.
  bool isConnected() const;
  /// Which connection it is: grows by one with each; 0 before the first.
  long connection() const;
  /// Sends a frame, without its length; nothing while nobody is connected.
  void send(FrameBytes&& frame);
  /// Memory of a frame that has left, for the next one; its contents are of no meaning.
  FrameBytes spare();
  /// The oldest frame that waits.
  std::optional<FrameBytes> receive();
  /// Waits until a frame is there. @returns false where none has come before `until`, or the client has gone.
  bool waitForFrame(std::chrono::steady_clock::time_point until);
  /// Waits until a client is there. @returns false where none has come before `until`
  bool waitForClient(std::chrono::steady_clock::time_point until);
  /// Ends the connection; a client may come again.
  void disconnect();
  ChannelCounts counts() const;

  // The sockets' side.
  void setWake(std::function<void()> wake) { wake_ = std::move(wake); }
  void open();
  void close(const std::string& why);
  bool hasRoom() const;
  void deliver(FrameBytes&& frame);
  /// The next frame to leave.
  std::optional<FrameBytes> nextToSend();
  /// A frame has left.
  void giveBack(FrameBytes&& frame);
  bool wantsEnd() const;

 private:
  void keepSpare(FrameBytes&& frame);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> wake_;
  const ChannelLimits limits_;
  bool connected_ = false, end_wanted_ = false;
  std::deque<FrameBytes> received_;
  std::deque<FrameBytes> to_send_;
  std::vector<FrameBytes> spares_;
  std::size_t bytes_to_send_ = 0;
  ChannelCounts counts_;
};

}  // namespace murosimf
