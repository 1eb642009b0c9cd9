#pragma once

/// @file In which direction to play the ball.
///
/// Every direction gets the value of the place where the ball would come to rest: a goal is worth most, then closeness
/// to the goal attacked; out of the field, into another robot, before the opponents' keeper or
/// towards the own goal costs. Values are averaged over the directions that a kick may err by, so a direction in the
/// middle of an opening beats one beside a post. Turning costs time, so the best direction is the one with the best
/// value less the cost of getting there.

#include <array>

#include "situation.h"

namespace murosimf::controllers {

class ShotChoice {
 public:
  /// Values all directions for a ball at ball_F. robots_F: where other robots stand.
  void evaluate(const Pitch& pitch, const Point& ball_F, std::span<const Point> robots_F);

  /// The direction in F [rad] to play when the kick would now go towards `present` [rad].
  double best(double present) const;
  /// Expected value [m] of a kick in this direction [rad].
  double value(double direction) const;

  /// How far a kicked ball rolls [m].
  static constexpr double kRange = 1.9;
  /// Value of a goal [m]: a place 4 m closer to the goal than its centre.
  static constexpr double kGoalValue = 4.0;
  /// Time and risk of turning, in the same unit [m/rad].
  static constexpr double kTurnCost = 0.9;

 private:
  static constexpr int kDirections = 72;
  static constexpr double kStep = 2 * kPi / kDirections;
  static std::size_t index(int i) { return static_cast<std::size_t>((i % kDirections + kDirections) % kDirections); }

  std::array<double, kDirections> values_{};  ///< of direction i kStep
};

}  // namespace murosimf::controllers
