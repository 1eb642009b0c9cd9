#pragma once

/// @file Keeps phase, amplitude, velocity and heading of a trot, and changes them no faster than the robot bears.

#include "attitude.h"
#include "trot.h"

namespace murosimf::controllers::trotter {

/// What the trunk feels of its own motion, in its own axes.
struct TrunkSense {
  Vector3 angular_velocity;  ///< [rad/s]
  Vector3 specific_force;    ///< [m/s^2]; zero where there is no accelerometer
};

class TrotEngine {
 public:
  /// Wants to move like this; starts to trot when the robot stands.
  void trot(const TrotCommand& wanted) { wanted_ = wanted, wants_to_trot_ = true; }
  /// Wants to stand: velocity to zero, then amplitude to zero, then still.
  void stop() { wanted_ = {}, wants_to_trot_ = false; }
  /// Advances by dt [s]. @return angles to command. No allocation.
  JointAngles step(double dt, const TrunkSense& felt);

  bool standing() const { return !wants_to_trot_ && amplitude_ <= 0 && velocity_ == TrotCommand{}; }
  const TrotCommand& velocity() const { return velocity_; }
  double phase() const { return phase_; }
  const Attitude& attitude() const { return attitude_; }
  void archive(client::StateArchive& archive);

  TrotParameters parameters;

 private:
  void feel(double dt, const TrunkSense& felt);
  void advance(double dt);
  TrotCommand steered() const;

  TrotCommand wanted_, velocity_;
  bool wants_to_trot_ = false;
  double phase_ = 0, amplitude_ = 0;
  double stepping_time_ = 0;  ///< since the robot last stood [s]
  double astray_ = 0;         ///< heading less what the commands add up to [rad]
  Attitude attitude_;
  Vector3 filtered_rate_;  ///< angular velocity after a first-order filter [rad/s]
};

}  // namespace murosimf::controllers::trotter
