#include "murosimf/modules/sensing/inertial_sensor.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr Variable<Vector3> kImuVelocity{"imu_velocity", "m/s", "velocity of the unit in the step before",
                                         Storage::kKept};
constexpr Variable<double> kImuStarted{"imu_started", "1", "1 once imu_velocity holds a velocity", Storage::kKept};
}  // namespace

void InertialSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kSense);
  d.needs(kTree);
  d.needs(kImuPlace);
  d.readsInStep(kShownBase);
  d.readsInStep(kShownBaseLast);
  d.readsInStep(kShownPosition, subset::kJoints);
  d.readsInStep(kShownPositionLast, subset::kJoints);
  d.adds(kGyroscope);
  d.adds(kAccelerometer);
  d.adds(kImuVelocity);
  d.adds(kImuStarted);
}

void InertialSensor::link(Links& links) {
  const MountPlace place = links.shared(kImuPlace);
  rows_ = kernelRows(links.shared(kTree));
  for (int row = place.row; row > 0; row = rows_[static_cast<std::size_t>(row)].parent)
    chain_.insert(chain_.begin(), row);
  arguments_ = {rows_.data(),
                chain_.data(),
                static_cast<int>(chain_.size()),
                kernelPose(place.X_RM),
                links.column(kShownPosition, subset::kJoints),
                links.column(kShownPositionLast, subset::kJoints),
                links.column(kShownBase),
                links.column(kShownBaseLast),
                links.column(kImuVelocity),
                links.column(kImuStarted),
                links.column(kGyroscope),
                links.column(kAccelerometer)};
  kernel_ = kernelOfWidth<InertialSensorArguments>(links.width());
}

}  // namespace murosimf
