#pragma once

/// @file How many bytes a client may be sent within a second.

#include <cstddef>
#include <deque>
#include <utility>

namespace murosimf::player_api {

class NetworkQuota {
 public:
  /// @param quota  [MiB/s]; infinite: there is none
  explicit NetworkQuota(double quota) : quota_(quota) {}

  /// Whether a message of so many bytes may be sent now [s], together with those of the second before.
  bool allows(double now, std::size_t bytes) {
    while (!sent_.empty() && now - sent_.back().first >= kWindow) {
      sum_ -= sent_.back().second;
      sent_.pop_back();
    }
    return static_cast<double>(sum_ + bytes) <= quota_ * kWindow * kMebibyte;
  }
  void count(double now, std::size_t bytes) {
    sent_.emplace_front(now, bytes);
    sum_ += bytes;
  }
  double quota() const { return quota_; }

 private:
  static constexpr double kWindow = 1, kMebibyte = 1048576;
  double quota_;
  std::deque<std::pair<double, std::size_t>> sent_;  // newest first
  std::size_t sum_ = 0;
};

}  // namespace murosimf::player_api
