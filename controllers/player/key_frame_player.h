#pragma once

/// @file Motions given as a sequence of postures with times: kicks, get-ups, gestures.
///
/// Between two postures every joint goes u^2 (3 - 2u) of the way, at rest at both ends, or evenly where a frame says
/// so: u in [0, 1] is the share of the frame's time that has passed.

#include <vector>

#include "ks21.h"
#include "murosimf/control/client/state_archive.h"

namespace murosimf::controllers {

struct KeyFrame {
  double duration = 0;   ///< from the posture before to this one [s], > 0
  JointAngles angles{};  ///< [rad]
  bool evenly = false;   ///< at constant speed instead of starting and ending at rest
};

/// Plays one of the motions that it was built with. Motions are named by their index.
class KeyFramePlayer {
 public:
  explicit KeyFramePlayer(std::vector<std::vector<KeyFrame>> motions) : motions_(std::move(motions)) {}

  /// Begins a motion from the angles that are commanded now.
  void start(int motion, const JointAngles& now);
  /// Advances by dt [s] and returns the angles to command. Does nothing but return the last posture when it is over.
  const JointAngles& step(double dt);
  /// Ends the motion where it is.
  void stop() { motion_ = -1; }
  bool running() const { return motion_ >= 0; }
  double elapsed() const { return elapsed_; }  ///< since the start of the motion [s]
  int motion() const { return motion_; }       ///< index, -1 when none runs
  /// Time from the start of a motion to the end of its last frame [s].
  double duration(int motion) const;
  void archive(client::StateArchive& archive);

 private:
  const std::vector<KeyFrame>& frames() const { return motions_[static_cast<std::size_t>(motion_)]; }

  std::vector<std::vector<KeyFrame>> motions_;
  int motion_ = -1;
  std::size_t frame_ = 0;
  double elapsed_ = 0;
  double time_ = 0;                ///< within the frame [s]
  JointAngles from_{}, angles_{};  ///< at the frame's start, commanded last [rad]
};

}  // namespace murosimf::controllers
