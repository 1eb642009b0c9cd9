#pragma once

/// @file A robot whose feet are where its joints say: for walks that can be computed by hand.
///
/// Each leg is a yaw, a slide forward and a slide upward: a sole stands at (x, +-d, z - h) in the base, turned by yaw
/// about the vertical through (0, +-d).

#include "modules/motion_world.h"
#include "murosimf/robot/tree_builder.h"

namespace murosimf::motion {

inline constexpr double kHalfStance = 0.05, kLegLength = 0.3;  // d, h [m]

inline RobotBlueprint makeStiltWalker() {
  TreeBuilder builder;
  const MassProperties mass = boxMass(0.1, {0.1, 0.05, 0.02}, {});
  Body base{"body", mass};
  const TreePlace hips = builder.base("hips").body(base).fork();
  const JointLimits limits{-3.0, 3.0, 1000.0, 1000.0};
  RobotModel model;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const std::string name = side == Side::kRight ? "right" : "left";
    const double y = side == Side::kRight ? -kHalfStance : kHalfStance;
    hips.translation({0, y, -kLegLength})
        .revolute("yaw_" + name, kAxisZ, limits)
        .body({"hip_" + name, mass})
        .prismatic("forward_" + name, kAxisX, limits)
        .body({"leg_" + name, mass})
        .prismatic("up_" + name, kAxisZ, limits)
        .body({"foot_" + name, mass});
  }
  model.name = "stilt_walker";
  model.tree = builder.build();
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Sole sole;
    sole.name = side == Side::kRight ? "sole_right" : "sole_left";
    sole.body = model.tree.bodyIndex(side == Side::kRight ? "foot_right" : "foot_left");
    sole.side = side;
    sole.length = 0.1, sole.width = 0.05;
    model.soles.push_back(sole);
  }
  ImuMount imu;
  imu.name = "imu", imu.body = 0;
  model.imus.push_back(imu);
  RobotBlueprint print{std::move(model), {}};
  print.flat = flattenTree(print.model.tree);
  return print;
}
inline const RobotBlueprint& stiltWalker() {
  static const RobotBlueprint print = makeStiltWalker();
  return print;
}

/// 1 at 0, -1 at 1/2, straight between, period 1.
inline double triangle(double t) {
  const double u = t - std::floor(t);
  return u < 0.5 ? 1 - 4 * u : 4 * u - 3;
}

/// One step: the other foot lands `length` ahead and turned by `turn`.
struct Stride {
  double length = 0, turn = 0;
};
/// Joint positions of a walk, `steps_per_stride` samples a stride. The left foot lands in stride 0. Paths are straight
/// through each landing, at `landing` of the stride: the landing foot goes on down and forward by what is the standing
/// one's way up and back.
inline std::vector<std::vector<double>> stiltWalk(const std::vector<Stride>& strides, int steps_per_stride,
                                                  double landing = 0.437) {
  std::vector<std::vector<double>> path;
  for (std::size_t k = 0; k < strides.size(); ++k) {
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    for (int i = 0; i < steps_per_stride; ++i) {
      // Within a stride the landing foot comes down: height 1 - 4 s, zero at s = 1/4.
      const double s = 0.25 + 0.25 * (static_cast<double>(i) / steps_per_stride - landing);
      const double height = 0.02 * triangle(s), reach = 1 + 0.3 * (s - 0.25);
      const double x = 0.5 * strides[k].length * reach, turn = 0.5 * strides[k].turn * reach;
      std::vector<double> q(6);
      q[0] = -sign * turn, q[3] = sign * turn;
      q[1] = -sign * x, q[4] = sign * x;
      q[2] = -0.5 * sign * height, q[5] = 0.5 * sign * height;
      path.push_back(std::move(q));
    }
  }
  return path;
}

}  // namespace murosimf::motion
