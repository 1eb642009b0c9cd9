#include "murosimf/simulation/interventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr std::size_t kUsualRequests = 64;  // at once: a kick-off places everybody
constexpr std::size_t kUsualLog = 1024;     // of a game; a longer one makes room now and then
}  // namespace

InterventionQueue::InterventionQueue(const World& world, LinkedWorld& linked, PairPhase& pairs,
                                     const std::vector<ObjectId>& robots, const std::vector<ObjectId>& free_bodies)
    : world_(world), pairs_(pairs), free_bodies_(free_bodies) {
  for (const ObjectId id : robots) robots_.emplace_back(world, linked, id);
  waiting_.reserve(kUsualRequests);
  log_.reserve(kUsualLog);
}

void InterventionQueue::request(long frame, const Intervention& intervention) {
  check(intervention);
  const Logged entry{frame, intervention};
  const auto before = [&](const Logged& a, const Logged& b) {
    if (a.frame != b.frame) return a.frame < b.frame;
    return world_.path(a.intervention.object) < world_.path(b.intervention.object);
  };
  waiting_.insert(std::upper_bound(waiting_.begin(), waiting_.end(), entry, before), entry);
}

/// Nothing that is not a number gets into physics, and nothing waits for an object that cannot be placed.
void InterventionQueue::check(const Intervention& i) const {
  const double sum = i.pose.x + i.pose.y + i.pose.heading + i.height + i.velocity.x + i.velocity.y + i.velocity.z;
  if (!std::isfinite(sum)) {
    throw std::invalid_argument(
        fmt::format("{} cannot be placed there: a number is not finite", world_.path(i.object)));
  }
  const bool known = i.kind == Intervention::Kind::kPlaceBody
                         ? std::find(free_bodies_.begin(), free_bodies_.end(), i.object) != free_bodies_.end()
                         : std::any_of(robots_.begin(), robots_.end(),
                                       [&](const RobotPlacer& placer) { return placer.robot() == i.object; });
  if (!known) throw std::invalid_argument("an intervention places an object that is no robot or free body");
}

void InterventionQueue::placeRobot(long frame, ObjectId robot, const PlanarPose& pose) {
  request(frame, {Intervention::Kind::kPlaceRobot, robot, pose, 0, {}});
}

void InterventionQueue::placeBody(long frame, ObjectId body, const Vector3& position, const Vector3& velocity) {
  request(frame, {Intervention::Kind::kPlaceBody, body, {position.x, position.y, 0}, position.z, velocity});
}

void InterventionQueue::apply(long frame) {
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
  for (RobotPlacer& placer : robots_) {
    if (placer.robot() == i.object) placer.place(i.pose);
  }
}

}  // namespace murosimf
