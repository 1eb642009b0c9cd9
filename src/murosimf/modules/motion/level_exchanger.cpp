#include "murosimf/modules/motion/level_exchanger.h"

#include <numeric>

namespace murosimf {

const OutsideAccess& LevelExchanger::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.reads(kBasePose);
    d.readsIfAdded(kBasePoseLast);
    d.sets(kBaseVelocity);
  });
  return access;
}

LevelExchanger::LevelExchanger(LinkedWorld& linked, ObjectId robot)
    : linked_(linked),
      robot_(robot),
      levels_(linked.levelCount(robot)),
      base_pose_(linked.handle(robot, kBasePose)),
      base_pose_last_(linked.handle(robot, kBasePoseLast)),
      base_velocity_(linked.handle(robot, kBaseVelocity)) {
  for (int level = 0; level < levels_; ++level) {
    period_ = std::lcm(period_, static_cast<long>(linked.longestPeriod(robot, level)));
  }
}

SpatialMotion<double> LevelExchanger::baseVelocity() const {
  if (base_velocity_.valid()) return base_velocity_.get();
  if (!base_pose_last_.valid()) return {};
  const Pose now = base_pose_.get(), last = base_pose_last_.get();
  const double per_second = 1 / (base_pose_.period() * linked_.frameLength());
  return {rotationLog(transposed(last.rotation) * now.rotation) * per_second,
          applyTransposed(now.rotation, now.translation - last.translation) * per_second};
}

void LevelExchanger::exchange(int level) {
  const SpatialMotion<double> velocity = baseVelocity();
  linked_.exchange(robot_, level);
  if (base_velocity_.valid()) base_velocity_.set(velocity);
}

}  // namespace murosimf
