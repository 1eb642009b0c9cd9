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
  d.needs(kImuPlace);
  d.readsInStep(kBodyPose, subset::kBodies);
  d.readsInStep(kBodyPoseLast, subset::kBodies);
  d.adds(kGyroscope);
  d.adds(kAccelerometer);
  d.adds(kImuVelocity);
  d.adds(kImuStarted);
}

void InertialSensor::link(Links& links) {
  const MountPlace place = links.shared(kImuPlace);
  arguments_ = {place.row,
                kernelPose(place.X_RM),
                links.column(kBodyPose, subset::kBodies),
                links.column(kBodyPoseLast, subset::kBodies),
                links.column(kImuVelocity),
                links.column(kImuStarted),
                links.column(kGyroscope),
                links.column(kAccelerometer)};
  kernel_ = kernelOfWidth<InertialSensorArguments>(links.width());
}

}  // namespace murosimf
