#include "murosimf/modules/sensing/prescribed_inertial_sensor.h"

#include <algorithm>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void PrescribedInertialSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kTree);
  d.needs(kImuPlace, subset::kImus);
  d.reads(kJointTurn, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.reads(kJointRateDemand, subset::kJoints);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBaseAcceleration);
  d.adds(kGyroscope, subset::kImus);
  d.adds(kAccelerometer, subset::kImus);
}

void PrescribedInertialSensor::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  for (int i = 0; i < links.count(subset::kImus); ++i) {
    const MountPlace place = links.shared(kImuPlace, subset::kImus, i);
    std::vector<int>& way = ways_.emplace_back();
    for (int row = place.row; row > 0; row = rows_[static_cast<std::size_t>(row)].parent) way.push_back(row);
    std::reverse(way.begin(), way.end());
    units_.push_back({way.data(), static_cast<int>(way.size()), place.row, kernelPose(place.X_RM)});
  }
  PrescribedInertialSensorArguments& a = arguments_;
  a.rows = rows_.data();
  a.units = units_.data(), a.count = static_cast<int>(units_.size());
  a.turn = links.column(kJointTurn, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.demand = links.column(kJointRateDemand, subset::kJoints);
  a.twist = links.column(kBodyTwist, subset::kBodies);
  a.base_acceleration = links.column(kBaseAcceleration);
  a.gyroscope = links.column(kGyroscope, subset::kImus);
  a.accelerometer = links.column(kAccelerometer, subset::kImus);
  kernel_ = kernelOfWidth<PrescribedInertialSensorArguments>(links.width());
}

}  // namespace murosimf
