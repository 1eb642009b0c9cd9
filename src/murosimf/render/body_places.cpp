#include "murosimf/render/body_places.h"

#include "murosimf/world/vocabulary.h"

namespace murosimf {

BodyPlaces::BodyPlaces(const RenderedObject& object) {
  const World& world = object.world;
  if (const auto fixed = world.find(object.object, kFixedPose)) {
    fixed_ = *fixed;
  } else if (const auto bodies = world.members(object.object, subset::kBodies); !bodies.empty()) {
    path_ = BodyPath(object.linked, object.object);
    rows_ = static_cast<int>(bodies.size());
  } else if (object.object != world.root()) {
    base_ = object.linked.handle(object.object, kBasePose);
  }
}

Pose BodyPlaces::pose(int row, long frame) const {
  if (path_.valid()) return path_.pose(row, path_.shareAfter(frame));
  return base_.valid() ? base_.get() : fixed_;
}

}  // namespace murosimf
