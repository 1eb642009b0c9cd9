#include "murosimf/modules/contact/placed_shapes.h"

#include <algorithm>

namespace murosimf {

namespace {

double squaredDifference(const Rotation3& a, const Rotation3& b) {
  return squaredNorm(a.x - b.x) + squaredNorm(a.y - b.y) + squaredNorm(a.z - b.z);
}

}  // namespace

void PlacedShapes::reserve(std::size_t shapes) {
  spheres_.reserve(shapes / kTogether + 1);
  poses_.reserve(shapes), travels_.reserve(shapes);
}

void PlacedShapes::place(const ContactRobot& robot, long now) {
  if (frame_ == now) return;
  const bool followed = frame_ == now - 1 && shapes_ == &robot.shapes();
  frame_ = now, shapes_ = &robot.shapes();
  count_ = shapes_->size();
  spheres_.resize((count_ + kTogether - 1) / kTogether);
  poses_.resize(count_), travels_.resize(count_);
  box_ = {};
  double longest = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Obstacle& shape = (*shapes_)[i];
    const bool same_body = i > 0 && (*shapes_)[i - 1].row == shape.row;
    const Pose X_WB = same_body ? poses_[i - 1] : robot.shownPose(shape.row);
    const double squared = squaredNorm(X_WB.translation - poses_[i].translation) +
                           squaredDifference(X_WB.rotation, poses_[i].rotation) * shape.farthest * shape.farthest;
    const double way = followed ? sqrt(2 * squared) : kUnknown;
    travels_[i] = {travels_[i].now + way, travels_[i].now};
    longest = max(longest, way);
    poses_[i] = X_WB;
    put(i, shape, X_WB);
  }
  longest_ = {longest_.now + longest, longest_.now};
}

void PlacedShapes::put(std::size_t i, const Obstacle& shape, const Pose& X_WB) {
  Eight& eight = spheres_[i / kTogether];
  const std::size_t k = i % kTogether;
  const Vector3 centre = X_WB * shape.X_BS.translation;
  eight.x[k] = centre.x, eight.y[k] = centre.y, eight.z[k] = centre.z, eight.reach[k] = shape.reach + kHalfStep;
  box_.hold(centre, eight.reach[k]);
}

}  // namespace murosimf
