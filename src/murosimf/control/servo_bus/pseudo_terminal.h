#pragma once

/// @file A pseudo-terminal in the place of a serial port.
///
/// Programs open the link as they would open /dev/ttyUSB0. The terminal passes bytes as they are (no echo, no line
/// ends), whatever speed a program sets. Nothing here waits: what cannot be written at once is dropped, as on a wire.

#include <span>
#include <string>

#include "murosimf/control/servo_bus/packet.h"
#include "murosimf/control/wire/file_descriptor.h"

namespace murosimf::servo_bus {

class PseudoTerminal {
 public:
  /// Opens a terminal, and a link to it; folders that are missing are made, a link that an earlier terminal left is
  /// replaced.
  /// @throws std::system_error where the system refuses; std::runtime_error where something else has the link's name
  explicit PseudoTerminal(std::string link);
  /// Removes the link, if it is still that of this terminal.
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  int number() const { return own_end_.number(); }
  /// The terminal itself: /dev/pts/7.
  const std::string& device() const { return device_; }
  const std::string& link() const { return link_; }
  /// Appends what has come, at most as much as a terminal holds.
  void read(Bytes& bytes) const;
  /// @returns how many bytes were taken
  std::size_t write(std::span<const std::uint8_t> bytes) const;

 private:
  void makeLink() const;

  std::string link_, device_;
  FileDescriptor own_end_, other_end_;  ///< the other end stays open, so that programs may come and go
};

}  // namespace murosimf::servo_bus
