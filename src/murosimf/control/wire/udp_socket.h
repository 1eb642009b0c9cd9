#pragma once

/// @file UDP sockets that never block: for the threads of adapters alone.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "murosimf/control/wire/file_descriptor.h"

namespace murosimf {

/// Where packets go to, or have come from.
struct UdpAddress {
  std::uint32_t host = 0;  ///< as in the socket's address
  std::uint16_t port = 0;
};

/// @throws std::invalid_argument for a host that is unknown
UdpAddress udpAddress(const std::string& host, int port);
/// A socket that receives on host:port (port 0: any free one), and may send to all of a network where `broadcast` says
/// so. @throws std::system_error, std::invalid_argument "cannot receive on HOST:PORT: REASON"
FileDescriptor openUdp(const std::string& host, int port, bool broadcast);
/// @returns whether it has left; a packet for which there is no room is lost, as on the way
bool sendUdp(const FileDescriptor& socket, const UdpAddress& to, std::span<const std::uint8_t> bytes);
/// The next packet that waits, cut off behind `largest` bytes. @returns false where none does
bool receiveUdp(const FileDescriptor& socket, std::vector<std::uint8_t>& bytes, UdpAddress& from, std::size_t largest);

}  // namespace murosimf
