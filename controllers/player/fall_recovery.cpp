#include "fall_recovery.h"

#include "get_up_motion.h"

namespace murosimf::controllers {

std::vector<KeyFrame> FallRecovery::restFrames(const JointAngles& walk_ready) {
  return {{kReturnTime, walk_ready, false}, {kStillTime, walk_ready, false}};
}

FallRecovery::FallRecovery(const JointAngles& walk_ready)
    : player_({getUpFrames(LyingSide::kFront, walk_ready), getUpFrames(LyingSide::kBack, walk_ready),
               getUpFrames(LyingSide::kFlank, walk_ready), restFrames(walk_ready)}) {}

JointAngles FallRecovery::step(double dt, const FallDetector& fall) {
  const bool rests = player_.motion() == kRest;
  const JointAngles angles = player_.step(dt);
  if (rests && fall.upright() && player_.elapsed() >= kReturnTime) {
    player_.stop();
  } else if (!player_.running()) {
    player_.start(rests ? static_cast<int>(fall.side()) : kRest, angles);
  }
  return angles;
}

}  // namespace murosimf::controllers
