#pragma once

/// @file The other end: connects to a server of frames and waits for each answer. Blocks; for clients and tests.

#include <cstdint>
#include <string>

#include "murosimf/control/wire/frame_channel.h"
#include "murosimf/control/wire/tcp_socket.h"

namespace murosimf {

class FrameClient {
 public:
  /// Tries again and again until the server listens. @throws std::system_error when it does not within `patience` [s]
  FrameClient(const std::string& host, int port, double patience);

  /// So many bytes as they are; false where the server closed before. @throws std::system_error
  bool readRaw(std::uint8_t* bytes, std::size_t size);
  void sendRaw(const std::uint8_t* bytes, std::size_t size);
  void send(const FrameBytes& frame);
  /// Waits for a frame; false where the server closed. @throws std::runtime_error when it announces more than `largest`
  bool receive(FrameBytes& frame, std::size_t largest);

 private:
  FileDescriptor socket_;
};

}  // namespace murosimf
