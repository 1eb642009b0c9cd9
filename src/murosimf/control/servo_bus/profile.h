#pragma once

/// @file The way on which a servo moves its goal: at an even speed, or with an acceleration as well.
///
/// v+ = v + clamp(v_wanted - v, +-a h), v_wanted towards the goal with min(v_max, sqrt(2 a d)), d what is left, in
/// steps h of at most 1 ms. A distance d takes d/v_max + v_max/a where it is longer than v_max^2/a, else
/// 2 sqrt(d/a). No v_max: the goal counts at once. [ROBOTIS e-Manual, "What is the Profile"]

namespace murosimf::servo_bus {

struct Profile {
  double position = 0;  ///< [rad]
  double velocity = 0;  ///< [rad/s]

  /// Moves on by dt towards a goal; 0 as a limit is none.
  void advance(double goal, double largest_velocity, double acceleration, double dt);
  /// Same, of a velocity that is asked for.
  void turn(double wanted_velocity, double acceleration, double dt);
};

}  // namespace murosimf::servo_bus
