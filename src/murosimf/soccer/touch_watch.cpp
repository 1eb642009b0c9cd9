#include "murosimf/soccer/touch_watch.h"

#include <algorithm>

#include "murosimf/algorithms/collision/detect_contact.h"

namespace murosimf {

TouchWatch::TouchWatch(Simulation& simulation, ObjectId robot, ObjectId obstacle)
    : path_(simulation.linked(), robot),
      robot_(partsOf(simulation.world(), robot, 0)),
      obstacle_(partsOf(simulation.world(), obstacle, kTouchGap)),
      kinematic_(simulation.linked().handle(robot, kBasePoseLast)),
      blocking_(*simulation.world().find(robot, kBlockingRadius)) {
  const std::vector<ObjectId>& fixed = simulation.participants().fixed;
  if (std::find(fixed.begin(), fixed.end(), obstacle) != fixed.end()) {
    fixed_ = *simulation.world().find(obstacle, kFixedPose);
  } else {
    moving_ = BodyPath(simulation.linked(), obstacle);
  }
  if (obstacle_.size() == 1 && obstacle_.front().shape.kind == CollisionKind::kCylinder)
    disc_radius_ = obstacle_.front().shape.half_size.x;
}

std::vector<TouchWatch::Part> TouchWatch::partsOf(const World& world, ObjectId object, double gap) {
  std::vector<Part> parts;
  for (const PlacedShape& s : *world.findShared(object, kShapes)) {
    if (!s.collides) continue;
    Part& part = parts.emplace_back();
    part.row = s.row, part.X_BS = s.X_BS;
    part.shape = collisionShapeOf(s.shape, s.hull.get());
    part.shape.half_size = part.shape.half_size + Vector3{gap, gap, gap};
    part.reach = boundingRadius(part.shape);
  }
  return parts;
}

bool TouchWatch::touches(long frame) const {
  const double share = path_.shareAfter(frame - 1);
  const Pose X_WO = moving_.valid() ? moving_.pose(0, moving_.shareAfter(frame - 1)) : fixed_;
  if (isHeldAt(X_WO, path_.position(0, share))) return true;
  ContactManifold manifold;
  for (const Part& mine : robot_) {
    const Pose X_WS = path_.pose(mine.row, share) * mine.X_BS;
    for (const Part& its : obstacle_) {
      const Pose X_WT = X_WO * its.X_BS;
      const double reach = mine.reach + its.reach;
      if (squaredNorm(X_WS.translation - X_WT.translation) > reach * reach) continue;
      detectContact(mine.shape, X_WS, its.shape, X_WT, manifold);
      if (manifold.count > 0) return true;
    }
  }
  return false;
}

bool TouchWatch::isHeldAt(const Pose& X_WO, const Vector3& p_WB) const {
  if (!kinematic_.valid() || disc_radius_ <= 0) return false;
  const double dx = p_WB.x - X_WO.translation.x, dy = p_WB.y - X_WO.translation.y;
  const double reach = blocking_ + disc_radius_;
  return dx * dx + dy * dy < reach * reach;
}

}  // namespace murosimf
