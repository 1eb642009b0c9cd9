#pragma once

/// @file A Kalman filter for a ball that rolls on the ground and slows down.
///
/// State      (x, y, vx, vy) in R: position [m] and velocity over the ground [m/s], in R's axes; covariance 4 x 4.
/// Roll       v loses kRollingDeceleration dt of its size and ends at rest; x += v dt + ...; the covariance moves like
///            that of constant velocity, disturbed by a white acceleration: F P F^T + G sigma^2 G^T, G = (dt^2/2, dt).
/// Turn       into the next ground frame by the odometry increment, plus its uncertainty.
/// Correct    by a sight: radially with the distance's variance, across with that of the bearing.
/// Source     [Bar-Shalom, Li, Kirubarajan 2001, 6.3]; for equal steps it settles at the alpha-beta filter of
///            [Kalata 1984].

#include <array>

#include "plane.h"

namespace murosimf::controllers {

/// A ball seen: where, and with which variances along the ray and across it [m^2].
struct BallSight {
  Point p_R;
  double along_variance = 0, across_variance = 0;
};

struct BallFilter {
  static constexpr double kRollingDeceleration = 0.3;  ///< [m/s^2]
  static constexpr double kAcceleration = 0.6;         ///< sigma, of what nobody can foresee [m/s^2]
  static constexpr double kLargestPositionVariance = 1.0, kLargestVelocityVariance = 1.0;

  std::array<double, 4> state{};
  std::array<std::array<double, 4>, 4> covariance{};

  Point position() const { return {state[0], state[1]}; }
  Point velocity() const { return {state[2], state[3]}; }

  /// Starts anew at a sight with a velocity of the given variance (per axis).
  void begin(const BallSight& sight, const Point& velocity, double velocity_variance);
  void roll(double dt);
  void turn(const PlanarPose& increment);
  /// e^T S^-1 e of the sight, two degrees of freedom.
  double squaredError(const BallSight& sight) const;
  void correct(const BallSight& sight);
  /// The ball was kicked or pushed: its velocity may be any, with this much more variance per axis [m^2/s^2].
  void disturb(double velocity_variance);

 private:
  void limitVariance(std::size_t i, double largest);
};

/// Rolls a ball for dt on its own, exactly: constant deceleration until it rests.
void rollBall(Point& p, Point& v, double dt);

}  // namespace murosimf::controllers
