#pragma once

/// @file What an oracle knows of the world: things that stand or move there, and lines on the ground.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// In the order of client::ThingKind. Kinds of things have errors of their own, as detectors of a vision have.
enum class SightKind : std::uint8_t { kBall, kRobot, kPost, kPole, kLine, kObstacle };
inline constexpr std::size_t kSightKinds = 6;
/// As parameters are called: ball_miss.
inline constexpr std::array<std::string_view, kSightKinds> kSightKindNames{"ball", "robot", "post",
                                                                           "pole", "line",  "obstacle"};
inline constexpr std::size_t kindIndex(SightKind kind) { return static_cast<std::size_t>(kind); }

/// A thing with its axis: a straight line from a to b, in the frame B of the object's base; W where there is no object.
/// Where it is seen is told by a; of a line on the ground, by both ends of what is seen of it.
struct Landmark {
  SightKind kind = SightKind::kBall;
  ObjectId object;        ///< whose shapes show it; invalid: paint on the ground
  int shape = -1;         ///< number of the one that does among those that are drawn; -1: all
  Vector3 a, b;           ///< a ball's centre, twice; foot and top of a post; ends of a line
  bool grounded = false;  ///< a: the place on the ground below a, however the object has turned
  double height = 0;      ///< of a above the ground [m], for what is seen but not there
  std::string mark;       ///< team of a robot, colour of a post or of a pole's top
  int number = 0;         ///< of a robot
};

}  // namespace murosimf
