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
  d.needs(kImuPlace, subset::kImus);
  d.readsInStep(kShownBase);
  d.readsInStep(kShownBaseLast);
  d.readsInStep(kShownPosition, subset::kJoints);
  d.readsInStep(kShownPositionLast, subset::kJoints);
  d.adds(kGyroscope, subset::kImus);
  d.adds(kAccelerometer, subset::kImus);
  d.adds(kImuVelocity, subset::kImus);
  d.adds(kImuStarted);
}

void InertialSensor::link(Links& links) {
  rows_ = kernelRows(links.shared(kTree));
  for (int i = 0; i < links.count(subset::kImus); ++i) {
    const MountPlace place = links.shared(kImuPlace, subset::kImus, i);
    std::vector<int>& chain = chains_.emplace_back();
    for (int row = place.row; row > 0; row = rows_[static_cast<std::size_t>(row)].parent)
      chain.insert(chain.begin(), row);
    units_.push_back({chain.data(), static_cast<int>(chain.size()), kernelPose(place.X_RM)});
  }
  arguments_ = {rows_.data(),
                units_.data(),
                static_cast<int>(units_.size()),
                links.column(kShownPosition, subset::kJoints),
                links.column(kShownPositionLast, subset::kJoints),
                links.column(kShownBase),
                links.column(kShownBaseLast),
                links.column(kImuVelocity, subset::kImus),
                links.column(kImuStarted),
                links.column(kGyroscope, subset::kImus),
                links.column(kAccelerometer, subset::kImus)};
  kernel_ = kernelOfWidth<InertialSensorArguments>(links.width());
}

}  // namespace murosimf
