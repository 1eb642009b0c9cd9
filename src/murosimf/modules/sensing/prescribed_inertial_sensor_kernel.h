#pragma once

/// @file Kernel of prescribed_inertial_sensor.h.

#include "murosimf/algorithms/inertial_reading.h"
#include "murosimf/algorithms/joint_bias.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

/// Where a unit sits, and how to get there.
struct UnitWay {
  const int* way = nullptr;  ///< rows from the base to the unit's body
  int joints = 0;            ///< on the way
  int row = 0;
  KernelPose X_RI;
};

struct PrescribedInertialSensorArguments {
  const KernelRow* rows = nullptr;
  const UnitWay* units = nullptr;
  int count = 0;
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
  for (int i = 0; i < a.count; ++i) {
    const UnitWay& unit = a.units[i];
    SpatialMotion<S> A = *columnAt<SpatialMotion<S>, S>(block, a.base_acceleration);
    for (int k = 0; k < unit.joints; ++k) {
      const int row = unit.way[k], j = row - 1;
      A = childAcceleration(a.rows[row], A, turn[j], twist[row], dq[j], (demand[j] - dq[j]) * per_second);
    }
    const InertialReading<S> reading = inertialReading(unit.X_RI, twist[unit.row], A, S(time.implicit));
    columnAt<Vec3<S>, S>(block, a.gyroscope)[i] = reading.gyroscope;
    columnAt<Vec3<S>, S>(block, a.accelerometer)[i] = reading.accelerometer;
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
