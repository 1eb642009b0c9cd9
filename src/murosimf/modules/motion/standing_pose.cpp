#include "murosimf/modules/motion/standing_pose.h"

#include <limits>

namespace murosimf {

namespace {

constexpr double kLevel = 1e-6;  // [m] below which a corner may lie under the sole that stands

/// Height of the lowest corner of a sole over the plane z = 0 of the frame in which its pose is given.
double lowestCorner(const Pose& X, const SolePlace& sole) {
  return X.translation.z - sole.half_length * abs(X.rotation.x.z) - sole.half_width * abs(X.rotation.y.z);
}

/// Height of the lowest point of a shape.
double lowestPoint(const Pose& X, const PlacedShape& s) {
  const Vector3 up = applyTransposed(X.rotation, Vector3{0, 0, 1});
  const Vector3& a = s.shape.half_size;
  switch (s.shape.kind) {
    case ShapeKind::kBox:
      return X.translation.z - (abs(up.x) * a.x + abs(up.y) * a.y + abs(up.z) * a.z);
    case ShapeKind::kCylinder:
      return X.translation.z - (sqrt(up.x * up.x + up.y * up.y) * a.x + abs(up.z) * a.z);
    case ShapeKind::kCapsule:
      return X.translation.z - (a.x + abs(up.z) * a.z);
    case ShapeKind::kConvex:
      return X.translation.z + dot(up, s.hull->vertex(s.hull->farthestVertex(-up)));
    case ShapeKind::kEllipsoid:
      break;
  }
  return X.translation.z - norm(Vector3{a.x * up.x, a.y * up.y, a.z * up.z});
}

}  // namespace

StandingPose::StandingPose(const World& world, ObjectId robot) {
  rows_ = kernelRows(*world.findShared(robot, kTree));
  X_BR_.resize(rows_.size());
  if (const auto* soles = world.findShared(robot, kSoles)) soles_ = *soles;
  if (const auto* shapes = world.findShared(robot, kShapes)) shapes_ = *shapes;
}

Pose StandingPose::flatOnSole() const {
  Pose best;
  double highest = -std::numeric_limits<double>::infinity();
  for (const SolePlace& stance : soles_) {
    const Pose X_SB = inverse(X_BR_[static_cast<std::size_t>(stance.mount.row)] * stance.mount.X_RM);
    double lowest = 0;
    for (const SolePlace& other : soles_) {
      const Pose X_SO = X_SB * X_BR_[static_cast<std::size_t>(other.mount.row)] * other.mount.X_RM;
      if (&other != &stance) lowest = min(lowest, lowestCorner(X_SO, other));
    }
    if (lowest >= min(highest, -kLevel)) highest = max(lowest, highest), best = X_SB;
  }
  return best;
}

Pose StandingPose::onLowestShape() const {
  double lowest = 0;
  for (const PlacedShape& s : shapes_) {
    if (s.collides) lowest = min(lowest, lowestPoint(X_BR_[static_cast<std::size_t>(s.row)] * s.X_BS, s));
  }
  return {Rotation3{}, {0, 0, -lowest}};
}

Pose StandingPose::find(std::span<const double> q, const PlanarPose& place) {
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    X_BR_[i] = childPose(X_BR_[static_cast<std::size_t>(rows_[i].parent)], rows_[i], q[i - 1]);
  }
  const Pose X = soles_.empty() ? onLowestShape() : flatOnSole();
  const double turn = place.heading - atan2(X.rotation.x.y, X.rotation.x.x);
  return {rotationZ(turn) * X.rotation, {place.x, place.y, X.translation.z}};
}

}  // namespace murosimf
