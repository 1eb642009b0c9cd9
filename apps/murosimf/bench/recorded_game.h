#pragma once

/// @file A game whose control is recorded once and replayed: the same commands in the same steps, so that physics goes
/// the same way to the last bit, and what is measured is the simulator alone.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/soccer/referee.h"

namespace murosimf {

/// What the joints of each robot were asked for in each control step, by robot, then step.
using GameCommands = std::vector<std::vector<std::vector<client::JointCommand>>>;

/// A game with its referee, and nobody else who watches.
class RecordedGame {
 public:
  /// Its robots' programs are the reference players, whose commands are kept in `commands`; or, where there are some
  /// already, programs that replay them. `commands` must live as long.
  /// @throws std::runtime_error with what the builder says
  RecordedGame(const Scene& scene, GameCommands& commands);
  ~RecordedGame();
  RecordedGame(const RecordedGame&) = delete;
  RecordedGame& operator=(const RecordedGame&) = delete;

  /// Goes on for so long. @return time of the wall clock [s]
  double run(double seconds);
  const Simulation& simulation() const { return *simulation_; }

 private:
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Referee> referee_;
};

/// Seven against seven KS21 at full detail on the field of 2025. @param noise  a distorted head camera each, 640 x
/// 480 at 30 Hz, whose pictures have so much noise; nothing: players are told what a vision could have found.
/// @throws std::runtime_error with what the reader says
Scene sevenAgainstSeven(std::optional<double> noise, int lanes, int threads);

}  // namespace murosimf
