#pragma once

/// @file Private to the sockets: addresses as the system's functions want them.

#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdint>
#include <string>

namespace murosimf {

/// The address of a host by name or number. @throws std::invalid_argument for one that is unknown
std::uint32_t lookUpHost(const std::string& host);
sockaddr_in internetAddress(std::uint32_t host, int port);

/// The sockets' functions want the general kind of address.
template <class Call>
auto withAddress(sockaddr_in& address, const Call& call) {
  return call(static_cast<sockaddr*>(static_cast<void*>(&address)), static_cast<socklen_t>(sizeof address));
}

}  // namespace murosimf
