#pragma once

/// @file The shapes of one robot in the world, at a frame's start.

#include <limits>

#include "murosimf/modules/contact/contact_robot.h"

namespace murosimf {

/// Axes along the world's.
struct BoundingBox {
  Vector3 low{kNowhere, kNowhere, kNowhere}, high{-kNowhere, -kNowhere, -kNowhere};

  void hold(const Vector3& centre, double radius) {
    for (int k = 0; k < 3; ++k) {
      low[k] = min(low[k], centre[k] - radius);
      high[k] = max(high[k], centre[k] + radius);
    }
  }
  bool overlaps(const BoundingBox& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
           b.low.z <= high.z;
  }

 private:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
};

struct PlacedShapes {
  long frame = -1;  ///< at whose start
  std::vector<Vector3> centres;
  BoundingBox box;

  void reserve(std::size_t shapes) { centres.reserve(shapes); }
  void place(const ContactRobot& robot, long now) {
    if (frame == now) return;
    frame = now;
    centres.clear();
    box = {};
    for (const Obstacle& shape : robot.shapes()) {
      centres.push_back(robot.bodyPose(shape.row) * shape.X_BS.translation);
      box.hold(centres.back(), shape.reach);
    }
  }
};

}  // namespace murosimf
