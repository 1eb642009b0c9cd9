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

/// Bounding spheres of its shapes, as lists of numbers: eight are looked at together.
class PlacedShapes {
 public:
  static constexpr std::size_t kTogether = 8;

  void reserve(std::size_t shapes) {
    for (std::vector<double>* list : {&x_, &y_, &z_, &reach_}) list->reserve(shapes + kTogether);
  }
  /// At the start of the frame `now`.
  void place(const ContactRobot& robot, long now) {
    if (frame_ == now) return;
    frame_ = now;
    count_ = robot.shapes().size();
    const std::size_t filled = (count_ + kTogether - 1) / kTogether * kTogether;
    for (std::vector<double>* list : {&x_, &y_, &z_}) list->assign(filled, 0);
    reach_.assign(filled, kNothing);
    box_ = {};
    for (std::size_t i = 0; i < count_; ++i) {
      const Obstacle& shape = robot.shapes()[i];
      const Vector3 centre = robot.bodyPose(shape.row) * shape.X_BS.translation;
      x_[i] = centre.x, y_[i] = centre.y, z_[i] = centre.z, reach_[i] = shape.reach;
      box_.hold(centre, shape.reach);
    }
  }
  std::size_t count() const { return count_; }
  Vector3 centre(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  double reach(std::size_t i) const { return reach_[i]; }
  const BoundingBox& box() const { return box_; }
  /// Calls visit(i) for each shape whose sphere meets the one about a centre, in their order, from `first` on.
  template <class Visit>
  void forNear(const Vector3& centre, double reach, Visit&& visit, std::size_t first = 0) const {
    for (std::size_t begin = first / kTogether * kTogether; begin < count_; begin += kTogether) {
      double apart[kTogether], near[kTogether];
      for (std::size_t k = 0; k < kTogether; ++k) {
        const double dx = x_[begin + k] - centre.x, dy = y_[begin + k] - centre.y, dz = z_[begin + k] - centre.z;
        near[k] = reach + reach_[begin + k];
        apart[k] = dx * dx + dy * dy + dz * dz;
      }
      for (std::size_t k = 0; k < kTogether; ++k) {
        const bool meets = near[k] >= 0 && apart[k] <= near[k] * near[k];
        if (meets && begin + k >= first) visit(begin + k);
      }
    }
  }

 private:
  static constexpr double kNothing = -1e9;  // reach of what fills up the lists
  long frame_ = -1;
  std::size_t count_ = 0;
  std::vector<double> x_, y_, z_, reach_;
  BoundingBox box_;
};

}  // namespace murosimf
