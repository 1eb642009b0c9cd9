#pragma once

/// @file TCP sockets that never block: for the threads of adapters alone.

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/control/wire/file_descriptor.h"

namespace murosimf {

/// Listens on host:port. The host is a name or an address; port 0 lets the system choose one.
/// @throws std::system_error, std::invalid_argument "cannot listen on HOST:PORT: REASON"
FileDescriptor listenTcp(const std::string& host, int port, int backlog);
/// Connects, and waits for it at most so long; the socket does not block afterwards.
/// @throws std::system_error, std::invalid_argument "cannot connect to HOST:PORT: REASON"
FileDescriptor connectTcp(const std::string& host, int port, double timeout);
/// The port that a socket is bound to.
int portOf(const FileDescriptor& socket);

/// Addresses that clients may come from.
class HostList {
 public:
  HostList() = default;
  /// Names and addresses; names are looked up here and now. @throws std::invalid_argument for one that is unknown
  explicit HostList(const std::vector<std::string>& hosts);
  bool allows(std::uint32_t address) const;

 private:
  std::vector<std::uint32_t> addresses_;  // as in the socket's address
};

/// A connection that was accepted.
struct AcceptedClient {
  FileDescriptor socket;
  std::uint32_t address = 0;  ///< as in the socket's address
  std::string name;           ///< "127.0.0.1:40312"
};
/// The next one that waits; its socket is closed where none does.
AcceptedClient acceptTcp(const FileDescriptor& listener);

}  // namespace murosimf
