#pragma once

/// @file Kernel of inertial_sensor.h.

#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

struct InertialSensorArguments {
  int row = 0;
  KernelPose X_RI;
  ColumnRef pose, pose_last, velocity, started, gyroscope, accelerometer;
};

void addBaselineKernels(KernelSet<InertialSensorArguments>& kernels);
void addWideKernels(KernelSet<InertialSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void inertialSensor(const InertialSensorArguments& a, const BlockMemory& block, const StepTime& time) {
  const Transform<S> X_RI = poseFrom<S>(a.X_RI);
  const Transform<S> now = columnAt<Transform<S>, S>(block, a.pose)[a.row] * X_RI;
  const Transform<S> last = columnAt<Transform<S>, S>(block, a.pose_last)[a.row] * X_RI;
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
