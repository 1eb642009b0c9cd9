#pragma once

/// @file What the body does: stand, walk, kick or get up, one after the other and never two at once.
///
/// A kick begins only when the robot has stood still for a moment, and the robot stands still for a moment after it.
/// A robot that has fallen drops what it does, gets up by itself and stands for a moment, whatever is wished.

#include <span>

#include "fall_detector.h"
#include "fall_recovery.h"
#include "key_frame_player.h"
#include "kick_motion.h"
#include "murosimf/control/client/robot_frames.h"
#include "walking_engine.h"

namespace murosimf::controllers {

/// Wish for the next control period.
struct MotionRequest {
  enum class Kind : std::uint8_t { kStand, kWalk, kKick };
  Kind kind = Kind::kStand;
  WalkCommand walk;   ///< with kWalk
  int foot = kRight;  ///< with kKick
};

/// What the body feels of its own motion.
struct BodySense {
  Vector3 angular_velocity;  ///< of the pelvis in its own axes [rad/s], used only with `feedback`
  Vector3 specific_force;    ///< of the accelerometer, trunk axes [m/s^2]; zero where there is none
};

/// Where the joints are.
JointAngles anglesOf(std::span<const client::JointReading> joints);

class BodyMotion {
 public:
  BodyMotion();

  /// Before the first step: tells where the joints are. From there they go to the ready posture within kStartTime: a
  /// command that jumps far throws a robot over.
  void startFrom(const JointAngles& q);
  /// Advances by dt [s] towards what is wished. A kick that has begun is played to its end, unless the robot falls.
  /// @return angles to command [rad]; head joints are 0. No allocation.
  JointAngles step(double dt, const MotionRequest& wish, const BodySense& felt, bool feedback);
  /// Somebody has put the robot on its feet.
  void putUpright();

  /// Stands still, long enough to start a kick.
  bool settled() const { return settled_time_ >= kSettleTime; }
  /// Lies or gets up; the soles do not carry it then.
  bool fallen() const { return recovery_.active(); }
  bool kicking() const { return kick_.running(); }
  /// Since the kick began [s]; the foot meets the ball at kKickContactTime.
  double kickTime() const { return kick_.elapsed(); }
  std::uint32_t kicksStarted() const { return kicks_started_; }
  const WalkCommand& velocity() const { return engine_.velocity(); }
  void archive(client::StateArchive& archive);

 private:
  static constexpr double kStartTime = 0.6;     ///< [s]
  static constexpr double kSettleTime = 0.3;    ///< standing still before a kick [s]
  static constexpr double kRecoveryTime = 0.3;  ///< and after it [s]

  bool startsKick(const MotionRequest& wish);
  JointAngles recover(double dt);
  JointAngles getReady(double dt);

  WalkingEngine engine_;
  KeyFramePlayer kick_;  ///< motion 0 with the right foot, 1 with the left
  FallDetector fall_;
  FallRecovery recovery_;
  JointAngles commanded_{}, first_{};
  double start_time_ = kStartTime;  ///< since startFrom()
  double settled_time_ = 0, recovery_time_ = 0;
  std::uint32_t kicks_started_ = 0;
};

}  // namespace murosimf::controllers
