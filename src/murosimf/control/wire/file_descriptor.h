#pragma once

/// @file A file descriptor that closes itself: sockets, pipes and terminals of the adapters' threads.

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace murosimf {

class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    if (this != &other) reset(std::exchange(other.number_, -1));
    return *this;
  }
  ~FileDescriptor() { reset(); }

  int number() const { return number_; }
  bool isOpen() const { return number_ >= 0; }
  /// Closes what it holds and takes this one.
  void reset(int number = -1) {
    if (number_ >= 0) ::close(number_);
    number_ = number;
  }

 private:
  int number_ = -1;
};

/// What a system call answered. @throws std::system_error "WHAT: REASON" where that is an error, below 0.
template <class Result>
Result checkedCall(Result result, std::string_view what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), fmt::format("{}", what));
  return result;
}

}  // namespace murosimf
