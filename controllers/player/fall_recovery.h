#pragma once

/// @file What a fallen robot does until it stands: rest, get up, look whether it stands, try again if not.
///
/// Rest takes 1.3 s: the joints go to the walk-ready pose, so that the body comes to lie as the get-up motions expect
/// it, and stay there for 1 s. A robot that is upright meanwhile has recovered; any other plays the motion for the side
/// on which it lies, and rests again. A robot on its flank rolls over first.

#include "fall_detector.h"
#include "key_frame_player.h"

namespace murosimf::controllers {

class FallRecovery {
 public:
  /// @param walk_ready  posture in which it rests and ends
  explicit FallRecovery(const JointAngles& walk_ready);

  /// Begins with a rest, from the angles that are commanded now.
  void begin(const JointAngles& now) { player_.start(kRest, now); }
  bool active() const { return player_.running(); }
  /// Advances by dt [s]. @return angles to command; the walk-ready pose in the step in which it becomes inactive.
  JointAngles step(double dt, const FallDetector& fall);
  void archive(client::StateArchive& archive) { archive(player_); }

 private:
  static constexpr int kRest = 3;             ///< index of a motion; those before it are LyingSide's
  static constexpr double kReturnTime = 0.3;  ///< to the walk-ready pose, first part of the rest [s]
  static constexpr double kStillTime = 1.0;   ///< in it [s]

  static std::vector<KeyFrame> restFrames(const JointAngles& walk_ready);

  KeyFramePlayer player_;
};

}  // namespace murosimf::controllers
