#pragma once

/// @file Rays of a range sensor into a scene: how far each goes until it meets something.
///
/// They meet all that is drawn, but what the sensor hides, and the ground z = 0, which has no end. Directions hold in
/// the sensor's frame S. Distances are exact to rounding (ray_distance.h).
/// Cost  A thing is looked at where the sphere about it is in reach of some ray: 10 operations a ray for each of those,
///       the shape's own where a ray passes through the sphere. A fan of rays in one plane leaves out what the plane
///       does not cut.

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/ray_scene.h"

namespace murosimf {

class RangeCaster {
 public:
  /// @param directions  of length 1
  /// @param largest     beyond which nothing matters [m]
  /// @param hidden      owners of drawables that no ray meets
  RangeCaster(std::vector<Vector3> directions, double largest, std::vector<std::uint32_t> hidden);

  /// Fills as many distances as there are directions; infinity where a ray meets nothing within `largest`.
  void cast(const RayScene& scene, const Pose& X_WS, std::span<double> distances) const;

 private:
  void castThing(const Drawable& thing, const Pose& X_WS, std::span<double> distances) const;
  void castGround(const Pose& X_WS, std::span<double> distances) const;

  std::vector<Vector3> directions_;
  double largest_;
  std::vector<std::uint32_t> hidden_;
  bool flat_;  // all directions in the plane z = 0 of S
};

}  // namespace murosimf
