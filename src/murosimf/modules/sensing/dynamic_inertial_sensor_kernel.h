#pragma once

/// @file Kernel of dynamic_inertial_sensor.h.

#include "murosimf/algorithms/inertial_reading.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct DynamicInertialSensorArguments {
  int row = 0;
  KernelPose X_RI;
  ColumnRef twist, acceleration, gyroscope, accelerometer;
};

void addBaselineKernels(KernelSet<DynamicInertialSensorArguments>& kernels);
void addWideKernels(KernelSet<DynamicInertialSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void dynamicInertialSensor(const DynamicInertialSensorArguments& a, const BlockMemory& block, const StepTime& time) {
  const InertialReading<S> reading =
      inertialReading(a.X_RI, columnAt<SpatialMotion<S>, S>(block, a.twist)[a.row],
                      columnAt<SpatialMotion<S>, S>(block, a.acceleration)[a.row], S(time.implicit));
  *columnAt<Vec3<S>, S>(block, a.gyroscope) = reading.gyroscope;
  *columnAt<Vec3<S>, S>(block, a.accelerometer) = reading.accelerometer;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
