#include "murosimf/control/wire/internet_address.h"

#include <fmt/format.h>
#include <netdb.h>

#include <cstring>
#include <stdexcept>

namespace murosimf {

std::uint32_t lookUpHost(const std::string& host) {
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_STREAM;
  if (const int error = getaddrinfo(host.c_str(), nullptr, &wanted, &found); error != 0)
    throw std::invalid_argument(fmt::format("host \"{}\": {}", host, gai_strerror(error)));
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, sizeof address);
  freeaddrinfo(found);
  return address.sin_addr.s_addr;
}

sockaddr_in internetAddress(std::uint32_t host, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = host;
  return address;
}

}  // namespace murosimf
