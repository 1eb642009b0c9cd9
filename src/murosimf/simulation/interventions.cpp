#include "murosimf/simulation/interventions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
/// Requests at once for which there is room from the start: a kick-off places everybody.
std::size_t usualRequests(std::size_t robots) { return 64 + 4 * robots; }
}  // namespace

InterventionQueue::InterventionQueue(const World& world, LinkedWorld& linked, PairPhase& pairs,
                                     const std::vector<ObjectId>& robots, const std::vector<ObjectId>& free_bodies)
    : world_(world), pairs_(pairs), free_bodies_(free_bodies) {
  for (const ObjectId id : robots) {
    robots_.emplace_back(world, linked, id);
    exchangers_.emplace_back(linked, id);
  }
  waiting_.reserve(usualRequests(robots.size()));
  applied_.reserve(usualRequests(robots.size()));
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
  const bool free = std::find(free_bodies_.begin(), free_bodies_.end(), i.object) != free_bodies_.end();
  const bool robot = indexOf(i.object) < robots_.size();
  const bool known = i.kind == Intervention::Kind::kPlaceBody ? free
                     : i.kind == Intervention::Kind::kPush    ? free || robot
                                                              : robot;
  if (!known) throw std::invalid_argument("an intervention on an object that is no robot or free body");
  const int rows = free ? 1 : static_cast<int>(world_.members(i.object, subset::kBodies).size());
  if (i.kind == Intervention::Kind::kPush) {
    if (i.level >= 0 && i.level < rows) return;
    throw std::invalid_argument(
        fmt::format("{} has {} bodies, and number {} is to be pushed", world_.path(i.object), rows, i.level));
  }
  const int levels = i.kind == Intervention::Kind::kExchangeLevel ? exchangers_[indexOf(i.object)].levelCount() : 1;
  if (i.level < 0 || i.level >= levels) {
    throw std::invalid_argument(fmt::format("{} was linked with {} levels of detail, and one of number {} is asked for",
                                            world_.path(i.object), levels, i.level));
  }
}

void InterventionQueue::placeRobot(long frame, ObjectId robot, const PlanarPose& pose) {
  request(frame, {Intervention::Kind::kPlaceRobot, robot, pose, 0, {}});
}

void InterventionQueue::placeBody(long frame, ObjectId body, const Vector3& position, const Vector3& velocity) {
  request(frame, {Intervention::Kind::kPlaceBody, body, {position.x, position.y, 0}, position.z, velocity});
}

void InterventionQueue::exchangeLevel(long frame, ObjectId robot, int level) {
  Intervention exchange;
  exchange.kind = Intervention::Kind::kExchangeLevel;
  exchange.object = robot;
  exchange.level = level;
  request(frame, exchange);
}

void InterventionQueue::push(long frame, ObjectId object, int row, const Vector3& p_W, const Vector3& force_W) {
  request(frame, {Intervention::Kind::kPush, object, {p_W.x, p_W.y, 0}, p_W.z, force_W, row});
}

void InterventionQueue::apply(long frame) {
  applied_.clear();
  for (auto next = waiting_.begin(); next != waiting_.end() && next->frame <= frame;) {
    if (!ready(next->intervention, frame)) {
      ++next;
      continue;
    }
    act(next->intervention);
    applied_.push_back({frame, next->intervention});
    next = waiting_.erase(next);
  }
}

std::size_t InterventionQueue::indexOf(ObjectId robot) const {
  const auto found =
      std::find_if(robots_.begin(), robots_.end(), [&](const RobotPlacer& placer) { return placer.robot() == robot; });
  return static_cast<std::size_t>(found - robots_.begin());
}

bool InterventionQueue::ready(const Intervention& i, long frame) const {
  return i.kind != Intervention::Kind::kExchangeLevel || exchangers_[indexOf(i.object)].ready(frame);
}

void InterventionQueue::act(const Intervention& i) {
  switch (i.kind) {
    case Intervention::Kind::kPlaceBody:
      return pairs_.placeBody(i.object, {rotationZ(i.pose.heading), {i.pose.x, i.pose.y, i.height}}, i.velocity);
    case Intervention::Kind::kPlaceRobot:
      return robots_[indexOf(i.object)].place(i.pose);
    case Intervention::Kind::kPush:
      return pairs_.push(i.object, i.level, {i.pose.x, i.pose.y, i.height}, i.velocity);
    case Intervention::Kind::kExchangeLevel:
      exchangers_[indexOf(i.object)].exchange(i.level);
      return robots_[indexOf(i.object)].catchUp();
  }
}

}  // namespace murosimf
