#include "murosimf/modules/sensing/prescribed_inertial_sensor.h"

#include <algorithm>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void PrescribedInertialSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kImuPlace);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kJointRateDemand, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBaseAcceleration);
  d.adds(kGyroscope);
  d.adds(kAccelerometer);
}

void PrescribedInertialSensor::link(Links& links) {
  const MountPlace place = links.shared(kImuPlace);
  rows_ = kernelRows(links.shared(kTree));
  for (int row = place.row; row > 0; row = rows_[static_cast<std::size_t>(row)].parent) way_.push_back(row);
  std::reverse(way_.begin(), way_.end());
  PrescribedInertialSensorArguments& a = arguments_;
  a.rows = rows_.data(), a.way = way_.data(), a.joints = static_cast<int>(way_.size());
  a.row = place.row;
  a.X_RI = kernelPose(place.X_RM);
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.demand = links.column(kJointRateDemand, subset::kJoints);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.base_acceleration = links.column(kBaseAcceleration);
  a.gyroscope = links.column(kGyroscope);
  a.accelerometer = links.column(kAccelerometer);
  kernel_ = kernelOfWidth<PrescribedInertialSensorArguments>(links.width());
}

}  // namespace murosimf
