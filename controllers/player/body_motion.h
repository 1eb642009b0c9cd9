#pragma once

/// @file What the body does: stand, walk or kick, one after the other and never two at once.
///
/// A kick begins only when the robot has stood still for a moment, and the robot stands still for a moment after it.

#include "key_frame_player.h"
#include "kick_motion.h"
#include "walking_engine.h"

namespace murosimf::controllers {

/// Wish for the next control period.
struct MotionRequest {
  enum class Kind : std::uint8_t { kStand, kWalk, kKick };
  Kind kind = Kind::kStand;
  WalkCommand walk;   ///< with kWalk
  int foot = kRight;  ///< with kKick
};

class BodyMotion {
 public:
  BodyMotion();

  /// Advances by dt [s] towards what is wished. A kick that has begun is played to its end.
  /// @param angular_velocity  of the pelvis in its own axes [rad/s], used only with `feedback`
  /// @return angles to command [rad]; head joints are 0. No allocation.
  JointAngles step(double dt, const MotionRequest& wish, const Vector3& angular_velocity, bool feedback);

  /// Stands still, long enough to start a kick.
  bool settled() const { return settled_time_ >= kSettleTime; }
  bool kicking() const { return kick_.running(); }
  /// Since the kick began [s]; the foot meets the ball at kKickContactTime.
  double kickTime() const { return kick_.elapsed(); }
  std::uint32_t kicksStarted() const { return kicks_started_; }
  const WalkCommand& velocity() const { return engine_.velocity(); }
  void archive(client::StateArchive& archive);

 private:
  static constexpr double kSettleTime = 0.3;    ///< standing still before a kick [s]
  static constexpr double kRecoveryTime = 0.3;  ///< and after it [s]

  bool startsKick(const MotionRequest& wish);

  WalkingEngine engine_;
  KeyFramePlayer kick_;  ///< motion 0 with the right foot, 1 with the left
  JointAngles commanded_{};
  double settled_time_ = 0, recovery_time_ = 0;
  std::uint32_t kicks_started_ = 0;
};

}  // namespace murosimf::controllers
