#pragma once

/// @file Keeps a cart from driving into what its laser scanner sees.
///
/// The points of a scan, on the base, are turned into the free way in a direction: how far a disc of the robot's size
/// gets before it meets one. Of directions beside the wanted one, the nearest with enough free way is taken.

#include <optional>
#include <span>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"

namespace murosimf::controllers::cart {

struct GroundPoint {
  double x = 0, y = 0;  ///< on the base, forward and to the left [m]
};

class LaserGuard {
 public:
  explicit LaserGuard(double radius = 0.18) : radius_(radius) {}
  void describe(std::span<const client::RangeSensorDescription> sensors) {
    sensors_.assign(sensors.begin(), sensors.end());
  }
  /// Takes over the scans of a laser scanner.
  void see(std::span<const client::RangeScan> scans);
  /// Points within `near` of this one are none to be kept away from: the ball.
  void forgive(std::optional<GroundPoint> point, double near) { forgiven_ = point, near_ = near; }
  /// How far the robot can go in this direction [rad, to the left of forward], up to `most` [m].
  double freeWay(double direction, double most) const;
  /// The direction next to the wanted one in which `way` metres are free, or the one with the most.
  double wayAround(double direction, double way) const;

  template <class Archive>
  void archive(Archive& archive) {
    archive(points_);
  }

 private:
  double radius_;
  std::vector<client::RangeSensorDescription> sensors_;
  std::vector<GroundPoint> points_;
  std::optional<GroundPoint> forgiven_;
  double near_ = 0;
};

}  // namespace murosimf::controllers::cart
