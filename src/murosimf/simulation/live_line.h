#pragma once

/// @file The one line of a terminal that tells how a run goes.
///
///     12.3 s   4.1 x real time   red 1 : 0 blue   slowest: publish 62 %
///
/// On a terminal it is written over itself about five times a second of wall time; elsewhere (a log file) a new line is
/// written every 10 simulated seconds.

#include <cstdio>
#include <string>

#include "murosimf/simulation/stage_clock.h"

namespace murosimf {

class LiveLine {
 public:
  struct Settings {
    std::FILE* out = stderr;
    double wall_period = 0.2;        ///< on a terminal [s]
    double simulated_period = 10.0;  ///< elsewhere [s]
  };
  /// Asks whether `out` is a terminal.
  explicit LiveLine(const Settings& settings);
  LiveLine(const Settings& settings, bool terminal) : settings_(settings), terminal_(terminal) {}
  ~LiveLine() { finish(); }

  /// True when update() would write; costs nothing. wall: any clock that only grows [s].
  bool isDue(double simulated, double wall) const;
  /// Call after every frame, or where isDue(). `score` is any short text.
  void update(double simulated, double wall, const StageClock& stages, const std::string& score);
  /// Ends the line, so that what follows starts on a new one.
  void finish();

 private:
  std::string compose(double simulated, double wall, const StageClock& stages, const std::string& score) const;

  Settings settings_;
  bool terminal_;
  bool started_ = false, open_ = false;
  std::size_t shown_ = 0;                      // characters on the open line
  double last_simulated_ = 0, last_wall_ = 0;  // [s]
  StageClock last_stages_;
};

}  // namespace murosimf
