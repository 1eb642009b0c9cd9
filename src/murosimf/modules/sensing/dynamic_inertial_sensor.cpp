#include "murosimf/modules/sensing/dynamic_inertial_sensor.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

void DynamicInertialSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  d.needs(kImuPlace, subset::kImus);
  d.reads(kBodyTwist, subset::kBodies);
  d.reads(kBodyAcceleration, subset::kBodies);
  d.adds(kGyroscope, subset::kImus);
  d.adds(kAccelerometer, subset::kImus);
}

void DynamicInertialSensor::link(Links& links) {
  for (int i = 0; i < links.count(subset::kImus); ++i) {
    const MountPlace place = links.shared(kImuPlace, subset::kImus, i);
    units_.push_back({place.row, kernelPose(place.X_RM)});
  }
  arguments_ = {units_.data(),
                static_cast<int>(units_.size()),
                links.column(kBodyTwist, subset::kBodies),
                links.column(kBodyAcceleration, subset::kBodies),
                links.column(kGyroscope, subset::kImus),
                links.column(kAccelerometer, subset::kImus)};
  kernel_ = kernelOfWidth<DynamicInertialSensorArguments>(links.width());
}

}  // namespace murosimf
