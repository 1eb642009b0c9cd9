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

/// How far something can have gone: a sum over frames that never falls [m].
struct Travel {
  double now = 0;
  double before = 0;  ///< in the frame before: bodies are halfway between two shown poses at least
};

/// Bounding spheres of its shapes, as lists of numbers: eight are looked at together.
/// Travel of a shape   the sum over frames of  sqrt(2 (|dp|^2 + |dR|^2 e^2)) >= |dp| + |dR| e,  which no point of it
///                     exceeds: p, R pose of its body, |dR| Frobenius norm, e Obstacle::farthest. Frames in which the
///                     robot was not placed count kUnknown.
class PlacedShapes {
 public:
  static constexpr std::size_t kTogether = 8;
  static constexpr double kUnknown = 100;  // [m]

  void reserve(std::size_t shapes);
  /// At the start of the frame `now`.
  void place(const ContactRobot& robot, long now);

  std::size_t count() const { return count_; }
  Vector3 centre(std::size_t i) const {
    const Eight& eight = spheres_[i / kTogether];
    const std::size_t k = i % kTogether;
    return {eight.x[k], eight.y[k], eight.z[k]};
  }
  double reach(std::size_t i) const { return spheres_[i / kTogether].reach[i % kTogether]; }
  const BoundingBox& box() const { return box_; }
  const Travel& travel(std::size_t i) const { return travels_[i]; }
  /// No shape of it has gone farther.
  const Travel& longestTravel() const { return longest_; }

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
  void put(std::size_t i, const Obstacle& shape, const Pose& X_WB);

  long frame_ = -2;
  const std::vector<Obstacle>* shapes_ = nullptr;  // those that it had then
  std::size_t count_ = 0;
  std::vector<Eight> spheres_;
  std::vector<Pose> poses_;  // of their bodies
  std::vector<Travel> travels_;
  Travel longest_;
  BoundingBox box_;
};

}  // namespace murosimf
