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
  /// Along the axis on which they are farthest apart [m]; negative where they overlap.
  double distance(const BoundingBox& b) const {
    double apart = -kNowhere;
    for (int k = 0; k < 3; ++k) apart = max(apart, max(low[k] - b.high[k], b.low[k] - high[k]));
    return apart;
  }

 private:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
};

/// Bounding spheres of its shapes, as lists of numbers: eight are looked at together.
class PlacedShapes {
 public:
  static constexpr std::size_t kTogether = 8;

  void reserve(std::size_t shapes) { spheres_.reserve(shapes / kTogether + 1); }
  /// At the start of the frame `now`.
  void place(const ContactRobot& robot, long now) {
    if (frame_ == now) return;
    frame_ = now;
    count_ = robot.shapes().size();
    spheres_.assign((count_ + kTogether - 1) / kTogether, {});
    box_ = {};
    for (std::size_t i = 0; i < count_; ++i) {
      const Obstacle& shape = robot.shapes()[i];
      const Vector3 centre = robot.shownPose(shape.row) * shape.X_BS.translation;
      const double reach = shape.reach + kHalfStep;
      Eight& eight = spheres_[i / kTogether];
      const std::size_t k = i % kTogether;
      eight.x[k] = centre.x, eight.y[k] = centre.y, eight.z[k] = centre.z, eight.reach[k] = reach;
      box_.hold(centre, reach);
    }
  }
  std::size_t count() const { return count_; }
  Vector3 centre(std::size_t i) const {
    const Eight& eight = spheres_[i / kTogether];
    const std::size_t k = i % kTogether;
    return {eight.x[k], eight.y[k], eight.z[k]};
  }
  double reach(std::size_t i) const { return spheres_[i / kTogether].reach[i % kTogether]; }
  const BoundingBox& box() const { return box_; }
  /// Calls visit(i) for each shape whose sphere meets the one about a centre, in their order, from `first` on.
  template <class Visit>
  void forNear(const Vector3& centre, double reach, Visit&& visit, std::size_t first = 0) const {
    for (std::size_t e = first / kTogether; e < spheres_.size(); ++e) {
      const Eight& eight = spheres_[e];
      double apart[kTogether], near[kTogether];
      for (std::size_t k = 0; k < kTogether; ++k) {
        const double dx = eight.x[k] - centre.x, dy = eight.y[k] - centre.y, dz = eight.z[k] - centre.z;
        near[k] = reach + eight.reach[k];
        apart[k] = dx * dx + dy * dy + dz * dz;
      }
      for (std::size_t k = 0; k < kTogether; ++k) {
        const std::size_t i = e * kTogether + k;
        if (i >= first && i < count_ && apart[k] <= near[k] * near[k]) visit(i);
      }
    }
  }

 private:
  static constexpr double kHalfStep = 0.003;  // [m] that shown poses may be off
  struct Eight {
    double x[kTogether] = {}, y[kTogether] = {}, z[kTogether] = {}, reach[kTogether] = {};
  };
  long frame_ = -1;
  std::size_t count_ = 0;
  std::vector<Eight> spheres_;
  BoundingBox box_;
};

}  // namespace murosimf
