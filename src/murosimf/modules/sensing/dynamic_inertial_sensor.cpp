#include "murosimf/modules/sensing/dynamic_inertial_sensor.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void DynamicInertialSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kImuPlace);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.adds(kGyroscope);
  d.adds(kAccelerometer);
}

void DynamicInertialSensor::link(Links& links) {
  const MountPlace place = links.shared(kImuPlace);
  arguments_ = {place.row,
                kernelPose(place.X_RM),
                links.column(kBodyTwist, subset::kBodies),
                links.column(kBodyAcceleration, subset::kBodies),
                links.column(kGyroscope),
                links.column(kAccelerometer)};
  kernel_ = kernelOfWidth<DynamicInertialSensorArguments>(links.width());
}

}  // namespace murosimf
