#pragma once

/// @file What a cart is to do, as a scenario's `role` says it.
///
///     square 0.8 0.3   drives a square with edges of 0.8 m at 0.3 m/s, by the turning of its wheels alone: on rollers
///                      it keeps its heading, on tyres it turns a quarter at each corner
///     drive 0.3 0 0.5  forward and to the left [m/s], turning to the left [rad/s], on and on
///     rest             stays where it is
/// Anything else, as "keeper" or nothing: it plays.

#include <string_view>

#include "wheel_drive.h"

namespace murosimf::controllers::cart {

enum class CartTask { kPlay, kSquare, kDrive, kRest };

struct CartPlan {
  CartTask task = CartTask::kPlay;
  double edge = 0.8, speed = 0.3;  ///< of a square [m, m/s]
  BaseMotion velocity;             ///< to be driven
};

/// @throws std::invalid_argument what is wrong with a square or a drive, in words
CartPlan readCartPlan(std::string_view role);

/// A place by odometry: where the robot stood at first is the origin.
struct Place {
  double x = 0, y = 0, heading = 0;
  /// Goes on by a way, along the arc that it is.
  void advance(const BaseMotion& way);
};

/// An angle brought into [-pi, pi].
double wrapped(double angle);

/// Drives a square, once.
class SquareDriver {
 public:
  SquareDriver() = default;
  SquareDriver(double edge, double speed, bool omnidirectional);
  /// The velocity that brings it on from this place.
  BaseMotion velocityAt(const Place& place);
  bool done() const { return corner_ == 4 && !turning_; }
  template <class Archive>
  void archive(Archive& archive) {
    archive(corner_, turning_);
  }

 private:
  BaseMotion towards(const Place& place, double x, double y, double heading) const;
  double edge_ = 0.8, speed_ = 0.3;
  bool omnidirectional_ = false;
  int corner_ = 0;        ///< that was reached last, 0 to 4
  bool turning_ = false;  ///< at it
};

}  // namespace murosimf::controllers::cart
