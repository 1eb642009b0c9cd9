#include "murosimf/control/wire/tcp_socket.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>

#include <algorithm>
#include <array>

#include "murosimf/control/wire/internet_address.h"

namespace murosimf {

namespace {

void setOption(const FileDescriptor& socket, int level, int option) {
  const int on = 1;
  ::setsockopt(socket.number(), level, option, &on, sizeof on);
}

std::string nameOf(const sockaddr_in& address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
  return fmt::format("{}:{}", text.data(), ntohs(address.sin_port));
}

/// Waits until a connection that was begun stands. @returns the error of the socket; 0: it stands
int finishConnecting(const FileDescriptor& socket, double timeout) {
  pollfd waiting{socket.number(), POLLOUT, 0};
  if (::poll(&waiting, 1, static_cast<int>(timeout * 1000)) == 0) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

FileDescriptor listenTcp(const std::string& host, int port, int backlog) {
  const std::string what = fmt::format("cannot listen on {}:{}", host, port);
  FileDescriptor listener(checkedCall(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), what));
  setOption(listener, SOL_SOCKET, SO_REUSEADDR);
  sockaddr_in address = internetAddress(lookUpHost(host), port);
  checkedCall(withAddress(address, [&](sockaddr* a, socklen_t n) { return ::bind(listener.number(), a, n); }), what);
  checkedCall(::listen(listener.number(), backlog), what);
  return listener;
}

FileDescriptor connectTcp(const std::string& host, int port, double timeout) {
  const std::string what = fmt::format("cannot connect to {}:{}", host, port);
  FileDescriptor socket(checkedCall(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), what));
  setOption(socket, IPPROTO_TCP, TCP_NODELAY);
  sockaddr_in address = internetAddress(lookUpHost(host), port);
  const int begun = withAddress(address, [&](sockaddr* a, socklen_t n) { return ::connect(socket.number(), a, n); });
  const int error = begun == 0 ? 0 : errno == EINPROGRESS ? finishConnecting(socket, timeout) : errno;
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
  return socket;
}

int portOf(const FileDescriptor& socket) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  withAddress(address, [&](sockaddr* a, socklen_t) { return ::getsockname(socket.number(), a, &size); });
  return ntohs(address.sin_port);
}

HostList::HostList(const std::vector<std::string>& hosts) {
  for (const std::string& host : hosts) addresses_.push_back(lookUpHost(host));
}

bool HostList::allows(std::uint32_t address) const {
  return std::find(addresses_.begin(), addresses_.end(), address) != addresses_.end();
}

AcceptedClient acceptTcp(const FileDescriptor& listener) {
  AcceptedClient client;
  sockaddr_in address{};
  socklen_t size = sizeof address;
  client.socket.reset(withAddress(address, [&](sockaddr* a, socklen_t) {
    return ::accept4(listener.number(), a, &size, SOCK_NONBLOCK | SOCK_CLOEXEC);
  }));
  if (!client.socket.isOpen()) return client;
  setOption(client.socket, IPPROTO_TCP, TCP_NODELAY);
  client.address = address.sin_addr.s_addr;
  client.name = nameOf(address);
  return client;
}

}  // namespace murosimf
