#pragma once

/// @file Kernel of inertial_sensor.h.

#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct InertialSensorArguments {
  const KernelRow* rows = nullptr;
  const int* chain = nullptr;  ///< rows from behind the base to that of the unit
  int chain_length = 0;
  KernelPose X_RI;
  ColumnRef q, q_last, base, base_last, velocity, started, gyroscope, accelerometer;
};

void addBaselineKernels(KernelSet<InertialSensorArguments>& kernels);
void addWideKernels(KernelSet<InertialSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// X_WI of the unit in one posture.
template <class S>
Transform<S> unitPose(const InertialSensorArguments& a, const Transform<S>& X_WB, const S* q) {
  Transform<S> X_WR = X_WB;
  for (int i = 0; i < a.chain_length; ++i) X_WR = childPose(X_WR, a.rows[a.chain[i]], q[a.chain[i] - 1]);
  return X_WR * poseFrom<S>(a.X_RI);
}

template <class S>
void inertialSensor(const InertialSensorArguments& a, const BlockMemory& block, const StepTime& time) {
  const Transform<S> now = unitPose(a, *columnAt<Transform<S>, S>(block, a.base), columnAt<S, S>(block, a.q));
  const Transform<S> last =
      unitPose(a, *columnAt<Transform<S>, S>(block, a.base_last), columnAt<S, S>(block, a.q_last));
  auto* velocity = columnAt<Vec3<S>, S>(block, a.velocity);
  S* started = columnAt<S, S>(block, a.started);
  const S per_second(1.0 / time.dt);
  const Vec3<S> v = (now.translation - last.translation) * per_second;
  const Vec3<S> change = select(*started > S(0), v - *velocity, Vec3<S>{S(0), S(0), S(0)});
  const Vec3<S> upward{change.x * per_second, change.y * per_second, fma(change.z, per_second, S(kGravity))};
  *columnAt<Vec3<S>, S>(block, a.gyroscope) = rotationLog(transposed(last.rotation) * now.rotation) * per_second;
  *columnAt<Vec3<S>, S>(block, a.accelerometer) = applyTransposed(now.rotation, upward);
  *velocity = v;
  *started = S(1);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
