#include "murosimf/modules/motion/robot_placer.h"

namespace murosimf {

const OutsideAccess& RobotPlacer::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.needs(kTree);
    d.adds(kPlacement);
    d.adds(kPlacementCount);
    d.readsIfAdded(kPlacementsShown);
    d.reads(kJointPosition, subset::kJoints);
    d.sets(kJointVelocity, subset::kJoints);
    d.sets(kBasePose);
    d.sets(kBaseVelocity);
  });
  return access;
}

RobotPlacer::RobotPlacer(const World& world, LinkedWorld& linked, ObjectId robot)
    : robot_(robot),
      placement_(linked.handle(robot, kPlacement)),
      count_(linked.handle(robot, kPlacementCount)),
      shown_(linked.handle(robot, kPlacementsShown)),
      q_(linked.handle(robot, kJointPosition, subset::kJoints)),
      dq_(linked.handle(robot, kJointVelocity, subset::kJoints)),
      base_pose_(linked.handle(robot, kBasePose)),
      base_velocity_(linked.handle(robot, kBaseVelocity)),
      standing_(world, robot),
      positions_(static_cast<std::size_t>(standing_.joints())) {}

void RobotPlacer::place(const PlanarPose& pose) {
  placement_.set(pose);
  count_.set(count_.get() + 1);
  if (base_velocity_.valid()) setState(pose);
}

void RobotPlacer::catchUp() {
  const bool waiting = shown_.valid() && count_.get() > 0 && shown_.get() != count_.get();
  if (waiting && base_velocity_.valid()) setState(placement_.get());
}

void RobotPlacer::setState(const PlanarPose& pose) {
  for (int j = 0; j < standing_.joints(); ++j) positions_[static_cast<std::size_t>(j)] = q_.get(j);
  base_pose_.set(standing_.find(positions_, pose));
  base_velocity_.set({});
  for (int j = 0; j < standing_.joints(); ++j) dq_.set(0, j);
}

}  // namespace murosimf
