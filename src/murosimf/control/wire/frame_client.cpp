#include "murosimf/control/wire/frame_client.h"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "murosimf/control/wire/frame_parser.h"

namespace murosimf {

namespace {

using Clock = std::chrono::steady_clock;

FileDescriptor connectPatiently(const std::string& host, int port, double patience) {
  const Clock::time_point until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
  for (;;) {
    try {
      return connectTcp(host, port, patience);
    } catch (const std::system_error&) {
      if (Clock::now() >= until) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
}

/// Waits until the socket is ready for it.
void await(const FileDescriptor& socket, short what) {
  pollfd waiting{socket.number(), what, 0};
  checkedCall(::poll(&waiting, 1, -1), "cannot wait for the server");
}

}  // namespace

FrameClient::FrameClient(const std::string& host, int port, double patience)
    : socket_(connectPatiently(host, port, patience)) {}

bool FrameClient::readRaw(std::uint8_t* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::recv(socket_.number(), bytes, size, 0);
    if (count == 0 || (count < 0 && errno == ECONNRESET)) return false;
    if (count < 0) {
      if (errno != EAGAIN && errno != EINTR) checkedCall(count, "cannot read from the server");
      await(socket_, POLLIN);
      continue;
    }
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

void FrameClient::sendRaw(const std::uint8_t* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::send(socket_.number(), bytes, size, MSG_NOSIGNAL);
    if (count < 0) {
      if (errno != EAGAIN && errno != EINTR) checkedCall(count, "cannot send to the server");
      await(socket_, POLLOUT);
      continue;
    }
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

void FrameClient::send(const FrameBytes& frame) {
  FrameBytes bytes(FrameParser::kHeader + frame.size());
  writeFrameHeader(frame.size(), bytes.data());
  std::copy(frame.begin(), frame.end(), bytes.begin() + FrameParser::kHeader);
  sendRaw(bytes.data(), bytes.size());
}

bool FrameClient::receive(FrameBytes& frame, std::size_t largest) {
  std::array<std::uint8_t, FrameParser::kHeader> header{};
  if (!readRaw(header.data(), header.size())) return false;
  std::size_t size = 0;
  for (const std::uint8_t byte : header) size = size << 8 | byte;
  if (size > largest)
    throw std::runtime_error(
        fmt::format("the server announced a frame of {} bytes, expected at most {}", size, largest));
  frame.resize(size);
  return readRaw(frame.data(), size);
}

}  // namespace murosimf
