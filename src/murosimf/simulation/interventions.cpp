#include "murosimf/simulation/interventions.h"

#include <algorithm>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

const OutsideAccess& InterventionQueue::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.adds(kPlacement);
    d.adds(kPlacementCount);
  });
  return access;
}

void InterventionQueue::request(long frame, const Intervention& intervention) {
  waiting_.push_back({frame, intervention});
}

void InterventionQueue::placeRobot(long frame, ObjectId robot, const PlanarPose& pose) {
  request(frame, {Intervention::Kind::kPlaceRobot, robot, pose, 0, {}});
}

void InterventionQueue::placeBody(long frame, ObjectId body, const Vector3& position, const Vector3& velocity) {
  request(frame, {Intervention::Kind::kPlaceBody, body, {position.x, position.y, 0}, position.z, velocity});
}

void InterventionQueue::apply(long frame) {
  if (waiting_.empty()) return;
  std::stable_sort(waiting_.begin(), waiting_.end(), [&](const Logged& a, const Logged& b) {
    if (a.frame != b.frame) return a.frame < b.frame;
    return world_.path(a.intervention.object) < world_.path(b.intervention.object);
  });
  std::size_t done = 0;
  for (; done < waiting_.size() && waiting_[done].frame <= frame; ++done) {
    act(waiting_[done].intervention);
    log_.push_back({frame, waiting_[done].intervention});
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(done));
}

void InterventionQueue::act(const Intervention& i) {
  if (i.kind == Intervention::Kind::kPlaceBody) {
    const Pose X_WB{rotationZ(i.pose.heading), {i.pose.x, i.pose.y, i.height}};
    pairs_.placeBody(i.object, X_WB, i.velocity);
    return;
  }
  Handle<PlanarPose> placement = linked_.handle(i.object, kPlacement);
  Handle<double> count = linked_.handle(i.object, kPlacementCount);
  placement.set(i.pose);
  count.set(count.get() + 1);
}

}  // namespace murosimf
