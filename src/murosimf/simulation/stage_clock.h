#pragma once

/// @file How long each stage of the frame takes.

#include <array>
#include <chrono>
#include <string_view>

namespace murosimf {

enum class Stage { kInterventions, kCommands, kPrescribe, kContacts, kAdvance, kPublish, kObserve, kCount };

constexpr std::string_view nameOf(Stage stage) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(Stage::kCount)> kNames{
      "interventions", "commands", "prescribe", "contacts", "advance", "publish", "observe"};
  return kNames[static_cast<std::size_t>(stage)];
}

/// Adds up wall time per stage: the time from one lap to the next counts for the stage named at its end.
class StageClock {
 public:
  void start() { last_ = std::chrono::steady_clock::now(); }
  void lap(Stage finished) {
    const auto now = std::chrono::steady_clock::now();
    seconds_[static_cast<std::size_t>(finished)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  double seconds(Stage stage) const { return seconds_[static_cast<std::size_t>(stage)]; }

 private:
  std::array<double, static_cast<std::size_t>(Stage::kCount)> seconds_{};
  std::chrono::steady_clock::time_point last_;
};

}  // namespace murosimf
