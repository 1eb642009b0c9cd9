#pragma once

/// @file Kernel of inertial_sensor.h.

#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

/// Where a unit sits, and how to get there.
struct UnitChain {
  const int* chain = nullptr;  ///< rows from behind the base to that of the unit
  int length = 0;
  KernelPose X_RI;
};

struct InertialSensorArguments {
  const KernelRow* rows = nullptr;
  const UnitChain* units = nullptr;
  int count = 0;
  ColumnRef q, q_last, base, base_last, velocity, started, gyroscope, accelerometer;
};

void addBaselineKernels(KernelSet<InertialSensorArguments>& kernels);
void addWideKernels(KernelSet<InertialSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// X_WI of the unit in one posture.
template <class S>
Transform<S> unitPose(const KernelRow* rows, const UnitChain& unit, const Transform<S>& X_WB, const S* q) {
  Transform<S> X_WR = X_WB;
  for (int i = 0; i < unit.length; ++i) X_WR = childPose(X_WR, rows[unit.chain[i]], q[unit.chain[i] - 1]);
  return X_WR * poseFrom<S>(unit.X_RI);
}

template <class S>
void inertialSensor(const InertialSensorArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto &base = *columnAt<Transform<S>, S>(block, a.base),
             &base_last = *columnAt<Transform<S>, S>(block, a.base_last);
  S* started = columnAt<S, S>(block, a.started);
  const S per_second(1.0 / time.dt);
  for (int i = 0; i < a.count; ++i) {
    const Transform<S> now = unitPose(a.rows, a.units[i], base, columnAt<S, S>(block, a.q));
    const Transform<S> last = unitPose(a.rows, a.units[i], base_last, columnAt<S, S>(block, a.q_last));
    Vec3<S>& velocity = columnAt<Vec3<S>, S>(block, a.velocity)[i];
    const Vec3<S> v = (now.translation - last.translation) * per_second;
    const Vec3<S> change = select(*started > S(0), v - velocity, Vec3<S>{S(0), S(0), S(0)});
    const Vec3<S> upward{change.x * per_second, change.y * per_second, fma(change.z, per_second, S(kGravity))};
    columnAt<Vec3<S>, S>(block, a.gyroscope)[i] = rotationLog(transposed(last.rotation) * now.rotation) * per_second;
    columnAt<Vec3<S>, S>(block, a.accelerometer)[i] = applyTransposed(now.rotation, upward);
    velocity = v;
  }
  *started = S(1);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
