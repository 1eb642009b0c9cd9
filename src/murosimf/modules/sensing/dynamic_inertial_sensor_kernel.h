#pragma once

/// @file Kernel of dynamic_inertial_sensor.h.

#include "murosimf/algorithms/inertial_reading.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

/// Where a unit sits.
struct UnitPlace {
  int row = 0;
  KernelPose X_RI;
};

struct DynamicInertialSensorArguments {
  const UnitPlace* units = nullptr;
  int count = 0;
  ColumnRef twist, acceleration, gyroscope, accelerometer;
};

void addBaselineKernels(KernelSet<DynamicInertialSensorArguments>& kernels);
void addWideKernels(KernelSet<DynamicInertialSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void dynamicInertialSensor(const DynamicInertialSensorArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* twist = columnAt<SpatialMotion<S>, S>(block, a.twist);
  const auto* acceleration = columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  for (int i = 0; i < a.count; ++i) {
    const UnitPlace& unit = a.units[i];
    const InertialReading<S> reading =
        inertialReading(unit.X_RI, twist[unit.row], acceleration[unit.row], S(time.implicit));
    columnAt<Vec3<S>, S>(block, a.gyroscope)[i] = reading.gyroscope;
    columnAt<Vec3<S>, S>(block, a.accelerometer)[i] = reading.accelerometer;
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
