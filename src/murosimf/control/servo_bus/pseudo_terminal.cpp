#include "murosimf/control/servo_bus/pseudo_terminal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <termios.h>

#include <array>
#include <filesystem>
#include <stdexcept>

namespace murosimf::servo_bus {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTerminalBuffer = 4096;

void makeRaw(int terminal) {
  termios settings{};
  checkedCall(::tcgetattr(terminal, &settings), "settings of the pseudo-terminal");
  ::cfmakeraw(&settings);
  checkedCall(::tcsetattr(terminal, TCSANOW, &settings), "settings of the pseudo-terminal");
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::string link) : link_(std::move(link)) {
  own_end_.reset(checkedCall(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK), "pseudo-terminal"));
  checkedCall(::grantpt(number()), "pseudo-terminal");
  checkedCall(::unlockpt(number()), "pseudo-terminal");
  std::array<char, 128> name{};
  checkedCall(-::ptsname_r(number(), name.data(), name.size()), "name of the pseudo-terminal");
  device_ = name.data();
  other_end_.reset(checkedCall(::open(device_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC), device_));
  makeRaw(other_end_.number());
  makeLink();
}

PseudoTerminal::~PseudoTerminal() {
  std::error_code ignored;
  if (fs::read_symlink(link_, ignored) == device_) fs::remove(link_, ignored);
}

void PseudoTerminal::makeLink() const {
  const fs::path path(link_);
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  const bool is_link = fs::is_symlink(fs::symlink_status(path));
  const bool ours = is_link && fs::read_symlink(path).string().starts_with("/dev/pts/");
  if (fs::exists(fs::symlink_status(path)) && !ours)
    throw std::runtime_error(fmt::format("{}: this is no link to a terminal, expected a free name", link_));
  const fs::path made = link_ + ".new";
  fs::remove(made);
  fs::create_symlink(device_, made);
  fs::rename(made, path);
}

void PseudoTerminal::read(Bytes& bytes) const {
  std::array<std::uint8_t, kTerminalBuffer> buffer;
  const ssize_t count = ::read(number(), buffer.data(), buffer.size());
  if (count > 0) bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + count);
}

std::size_t PseudoTerminal::write(std::span<const std::uint8_t> bytes) const {
  const ssize_t count = ::write(number(), bytes.data(), bytes.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace murosimf::servo_bus
