#pragma once

/// @file The wheels of a robot as one drive: velocity of the base to rates of wheels, and turning of wheels to a way.
///
/// A wheel of radius r at p, which turns at w and drives along d, rolls without slip when what it grips holds:
///     tyre      d . (v + omega x p) = r w,   n . (v + omega x p) = 0,   n across d
///     rollers   g . (v + omega x p) = r w (g . d),   g the axle of the lowest roller
/// Rates follow from each wheel's own equation. The way of the base is what fits all equations best, least squares, for
/// the turning of the wheels in a control period: what the robot can know, as long as nothing slips.

#include <span>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"

namespace murosimf::controllers::cart {

/// Of the base in its own axes: forward, to the left [m or m/s], turning to the left [rad or rad/s].
struct BaseMotion {
  double x = 0, y = 0, turn = 0;
};

class WheelDrive {
 public:
  WheelDrive() = default;
  /// @throws std::invalid_argument for a robot whose wheels cannot drive it forward and turn it, in words
  explicit WheelDrive(const client::RobotDescription& robot);

  /// Whether it can move sideways: all of its wheels have rollers.
  bool omnidirectional() const { return omnidirectional_; }
  /// Commands of all wheels for this velocity, slowed down as a whole where one would turn too fast.
  void command(const BaseMotion& velocity, std::span<client::JointCommand> joints) const;
  /// The way of the base while its wheels turned from these positions to those of `joints`; overwrites the former.
  BaseMotion wayOf(std::span<const client::JointReading> joints, std::vector<double>& last) const;
  std::size_t wheelCount() const { return wheels_.size(); }

 private:
  /// x gx + y gy + turn arm = rolled.
  struct Grip {
    double gx = 0, gy = 0, arm = 0;
    double per_turn = 0;  ///< rolled by one rad of the wheel [m]
    int wheel = 0;
  };
  struct Wheel {
    std::size_t joint = 0;
    double fastest = 0;  ///< [rad/s]
    Grip drive;          ///< that makes it turn
  };
  void addWheel(const client::WheelDescription& wheel, double fastest);
  void addGrip(const client::WheelDescription& wheel, double gx, double gy, double per_turn);
  bool invert();

  std::vector<Wheel> wheels_;
  std::vector<Grip> grips_;
  double inverse_[3][3] = {};  ///< of the normal equations
  bool omnidirectional_ = true;
};

}  // namespace murosimf::controllers::cart
