#include "murosimf/modules/contact/blocking_phase.h"

#include "murosimf/math/random.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

const OutsideAccess& BlockingPhase::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.needs(kBlockingRadius);
    d.reads(kBasePose);
    d.readsIfAdded(kBasePoseLast);
    d.adds(kPlanarShift);
  });
  return access;
}

BlockingPhase::BlockingPhase(const World& world, LinkedWorld& linked, std::vector<ObjectId> robots,
                             std::vector<ObjectId> fixed)
    : frame_length_(linked.frameLength()) {
  for (const ObjectId id : robots) {
    robots_.push_back(
        {linked.handle(id, kBasePose), linked.handle(id, kBasePoseLast), linked.handle(id, kPlanarShift)});
    BlockingDisc& disc = discs_.emplace_back();
    disc.name = hashName(world.path(id));
    disc.radius = *world.find(id, kBlockingRadius);
  }
  for (const ObjectId id : fixed) {
    const Pose X_WB = *world.find(id, kFixedPose);
    for (const PlacedShape& s : *world.findShared(id, kShapes)) {
      const Pose X_WS = X_WB * s.X_BS;
      const bool round = s.shape.kind == ShapeKind::kCylinder || s.shape.kind == ShapeKind::kCapsule;
      if (!s.collides || !round || abs(X_WS.rotation.z.z) < 0.9) continue;
      discs_.push_back(
          {hashName(world.path(id)), true, s.shape.half_size.x, X_WS.translation.x, X_WS.translation.y, 0, 0});
    }
  }
  wanted_.reserve(discs_.size());
  rule_.reserve(static_cast<int>(discs_.size()));
}

void BlockingPhase::advance(long frame) {
  int longest = 0;
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (i + kAhead < robots_.size()) robots_[i + kAhead].fetch(frame);
    const Robot& robot = robots_[i];
    const Vector3 now = robot.pose.get().translation;
    discs_[i].fixed = !robot.last.valid();
    if (discs_[i].fixed) {
      discs_[i].x = now.x, discs_[i].y = now.y;
      discs_[i].dx = discs_[i].dy = 0;
      continue;
    }
    const bool updated = frame % robot.pose.period() == 0;
    // What the last shift contributed is no part of the robot's own way.
    const Vector3 way = updated ? now - robot.last.get().translation - robot.shift.get() : Vector3{};
    discs_[i].x = now.x, discs_[i].y = now.y;
    discs_[i].dx = way.x, discs_[i].dy = way.y;
    if (updated && robot.pose.period() > longest) longest = robot.pose.period();
  }
  if (longest == 0) return;
  wanted_.assign(discs_.begin(), discs_.begin() + static_cast<std::ptrdiff_t>(robots_.size()));
  rule_.apply(discs_, longest * frame_length_);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    if (!discs_[i].fixed && frame % robot.pose.period() == 0)
      robot.shift.set({discs_[i].dx - wanted_[i].dx, discs_[i].dy - wanted_[i].dy, 0});
  }
}

}  // namespace murosimf
