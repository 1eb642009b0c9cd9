#pragma once

/// @file Kernel of prescribed_inertial_sensor.h.

#include "murosimf/algorithms/inertial_reading.h"
#include "murosimf/algorithms/joint_bias.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct PrescribedInertialSensorArguments {
  const KernelRow* rows = nullptr;
  const int* way = nullptr;  ///< rows from the base to the unit's body
  int joints = 0;            ///< on the way
  int row = 0;
  KernelPose X_RI;
  ColumnRef turn, dq, demand, twist, base_acceleration, gyroscope, accelerometer;
};

void addBaselineKernels(KernelSet<PrescribedInertialSensorArguments>& kernels);
void addWideKernels(KernelSet<PrescribedInertialSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void prescribedInertialSensor(const PrescribedInertialSensorArguments& a, const BlockMemory& block,
                              const StepTime& time) {
  const auto* turn = columnAt<SinCos<S>, S>(block, a.turn);
  const S *dq = columnAt<S, S>(block, a.dq), *demand = columnAt<S, S>(block, a.demand);
  const auto* twist = columnAt<SpatialMotion<S>, S>(block, a.twist);
  const S per_second(1 / time.dt);
  SpatialMotion<S> A = *columnAt<SpatialMotion<S>, S>(block, a.base_acceleration);
  for (int k = 0; k < a.joints; ++k) {
    const int row = a.way[k], j = row - 1;
    A = childAcceleration(a.rows[row], A, turn[j], twist[row], dq[j], (demand[j] - dq[j]) * per_second);
  }
  const InertialReading<S> reading = inertialReading(a.X_RI, twist[a.row], A, S(time.implicit));
  *columnAt<Vec3<S>, S>(block, a.gyroscope) = reading.gyroscope;
  *columnAt<Vec3<S>, S>(block, a.accelerometer) = reading.accelerometer;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
