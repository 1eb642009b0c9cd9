#include "murosimf/control/wire/udp_socket.h"

#include "murosimf/control/wire/internet_address.h"

namespace murosimf {

UdpAddress udpAddress(const std::string& host, int port) {
  return {lookUpHost(host), static_cast<std::uint16_t>(port)};
}

FileDescriptor openUdp(const std::string& host, int port, bool broadcast) {
  const std::string what = fmt::format("cannot receive on {}:{}", host, port);
  FileDescriptor socket(checkedCall(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), what));
  const int on = 1;
  if (broadcast) checkedCall(::setsockopt(socket.number(), SOL_SOCKET, SO_BROADCAST, &on, sizeof on), what);
  sockaddr_in address = internetAddress(lookUpHost(host), port);
  checkedCall(withAddress(address, [&](sockaddr* a, socklen_t n) { return ::bind(socket.number(), a, n); }), what);
  return socket;
}

bool sendUdp(const FileDescriptor& socket, const UdpAddress& to, std::span<const std::uint8_t> bytes) {
  sockaddr_in address = internetAddress(to.host, to.port);
  const auto sent = withAddress(address, [&](sockaddr* a, socklen_t n) {
    return ::sendto(socket.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL, a, n);
  });
  return sent == static_cast<ssize_t>(bytes.size());
}

bool receiveUdp(const FileDescriptor& socket, std::vector<std::uint8_t>& bytes, UdpAddress& from, std::size_t largest) {
  sockaddr_in address{};
  bytes.resize(largest);
  const auto size = withAddress(address, [&](sockaddr* a, socklen_t n) {
    return ::recvfrom(socket.number(), bytes.data(), bytes.size(), 0, a, &n);
  });
  bytes.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
  from = {address.sin_addr.s_addr, ntohs(address.sin_port)};
  return size >= 0;
}

}  // namespace murosimf
