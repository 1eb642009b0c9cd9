#pragma once

/// @file Kernel of dynamic_inertial_sensor.h.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/linking/kernel.h"
#include "murosimf/math/spatial.h"

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
  const Transform<S> X_RI = poseFrom<S>(a.X_RI);
  const SpatialMotion<S> V = columnAt<SpatialMotion<S>, S>(block, a.twist)[a.row];
  const SpatialMotion<S> A = columnAt<SpatialMotion<S>, S>(block, a.acceleration)[a.row];
  const Vec3<S>& p = X_RI.translation;
  const Vec3<S> force = A.v + cross(A.w, p) + cross(V.w, V.v + cross(V.w, p));
  *columnAt<Vec3<S>, S>(block, a.gyroscope) = applyTransposed(X_RI.rotation, V.w + A.w * S(time.implicit));
  *columnAt<Vec3<S>, S>(block, a.accelerometer) = applyTransposed(X_RI.rotation, force);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
