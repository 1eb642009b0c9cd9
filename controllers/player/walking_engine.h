#pragma once

/// @file A gait with open-loop foot paths: joint angles as a function of one phase and a wanted velocity.
///
/// The feet ride on the ground that moves under the trunk. A stance foot follows exp(-xi tau), xi = (vx, vy, omega),
/// exactly, so both feet agree in double support and a robot that does not slip moves by exactly what was commanded.
/// A swing foot returns on a quintic whose ends continue the speed of the ground, scaled by kappa. The trunk sways
/// towards the stance foot and leans forward. Phase phi in [0, 1) is one cycle of two steps: the left foot swings
/// around phi = 1/4, the right one around 3/4. Symbols: T period, sigma swing share of the cycle, u in [0, 1) way
/// through the swing, tau time relative to mid stance [s], zeta height of the swing foot over its largest.

#include "ks21.h"
#include "murosimf/control/client/state_archive.h"
#include "murosimf/math/transform.h"

namespace murosimf::controllers {

/// Velocity of the trunk over the ground, in its own axes.
struct WalkCommand {
  double vx = 0, vy = 0;  ///< forward, to the left [m/s]
  double omega = 0;       ///< to the left [rad/s]
  friend bool operator==(const WalkCommand&, const WalkCommand&) = default;
};

struct WalkParameters {
  double period = 0.52;                                   ///< T, two steps [s]
  double double_support = 0.08;                           ///< share of the cycle with both feet down, delta
  double half_foot_distance = 0.053, hip_height = 0.211;  ///< hip above ankle [m]
  double foot_forward = -0.008;                           ///< ankle before the hip [m]
  double lift = 0.022, sway = 0.013;                      ///< [m]
  double sway_lead = 0.027;                               ///< of the cycle
  double lean = degrees(6.5);                             ///< trunk pitch, forward positive [rad]
  double landing_speed = 0.30;                            ///< kappa: share of ground speed at lift and touch-down
  double stance_hip_roll = degrees(2.5);                  ///< lifts the swing side in mid swing [rad]
  double arm_gain = 0.6;
  double ankle_pitch_gain = 0.10, hip_pitch_gain = 0.10, ankle_roll_gain = 0.05;  ///< gyro feedback [s]
  double start_time = 1.0;                                                        ///< stepping on the spot first [s]
  WalkCommand lowest{-0.10, -0.08, -1.0}, highest{0.25, 0.08, 1.0};
  WalkCommand largest_change{0.15, 0.10, 1.0};  ///< per second
};

/// Joint angles of the gait [rad], whole body; waist and head are 0. amplitude in [0, 1] scales sway, lift and arms.
JointAngles walkingPose(const WalkParameters& walk, double phase, double amplitude, const WalkCommand& velocity);

/// Keeps phase, amplitude and velocity, and changes them no faster than the robot bears.
class WalkingEngine {
 public:
  /// Wants to move like this; starts to step when the robot stands.
  void walk(const WalkCommand& wanted) { wanted_ = wanted, wants_to_walk_ = true; }
  /// Wants to stand: velocity to zero, then amplitude to zero, then still.
  void stop() { wanted_ = {}, wants_to_walk_ = false; }
  /// Stands at once: for a robot that has fallen.
  void halt();
  /// Advances by dt [s]. angular_velocity: of the pelvis in its own axes [rad/s], used only with `feedback`.
  /// @return angles to command. Overwrites nothing else; no allocation.
  JointAngles step(double dt, const Vector3& angular_velocity, bool feedback);

  bool standing() const { return !wants_to_walk_ && amplitude_ <= 0 && velocity_ == WalkCommand{}; }
  const WalkCommand& velocity() const { return velocity_; }
  double phase() const { return phase_; }
  double amplitude() const { return amplitude_; }
  void archive(client::StateArchive& archive);

  WalkParameters parameters;

 private:
  void advance(double dt);
  void addFeedback(JointAngles& angles) const;

  WalkCommand wanted_, velocity_;
  bool wants_to_walk_ = false;
  double phase_ = 0, amplitude_ = 0;
  double stepping_time_ = 0;  ///< since the robot last stood [s]
  Vector3 filtered_rate_;     ///< angular velocity after a first-order filter [rad/s]
};

}  // namespace murosimf::controllers
