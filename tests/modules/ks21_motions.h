#pragma once

/// @file What KS21 does in tests of dynamics: stands, squats, walks.

#include "modules/dynamic_world.h"
#include "player/leg_inverse_kinematics.h"

namespace murosimf::motion {

inline const std::vector<double> kReady = gait(0, {}, 0);  // walk-ready

/// Joint angles with the hips this far above the ankles, trunk leaning as when it walks.
inline std::vector<double> squat(double height) {
  std::vector<double> q = kReady;
  const Rotation3 R = rotationY(-6.5 * kPi / 180);
  const auto leg = controllers::solveLeg(R * Vector3{-0.012, 0, -height}, R).angles;
  for (const std::size_t first : {std::size_t{9}, std::size_t{15}}) {
    std::copy(leg.begin(), leg.end(), q.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return q;
}

/// Walks by the reference gait for `seconds`, after 2.5 s in which it gets going. @return poses of its base at both
/// ends
struct Way {
  Pose begin, end;
};
inline Way walk(DynamicWorld& world, ObjectId robot, const controllers::WalkCommand& wanted, double seconds) {
  constexpr double kPeriod = 0.52, kControl = 0.01;
  Way way;
  for (double t = 0; t < seconds + 2.5; t += kControl) {
    const double amplitude = std::min(1.0, t / (2 * kPeriod)), share = std::clamp((t - 1) / 1.5, 0.0, 1.0);
    world.command(robot, gait(t / kPeriod, {wanted.vx * share, wanted.vy * share, wanted.omega * share}, amplitude));
    if (t < 2.5) way.begin = world.base(robot);
    world.run(kControl);
  }
  way.end = world.base(robot);
  return way;
}

}  // namespace murosimf::motion
