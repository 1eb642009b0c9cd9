#pragma once

/// @file What an inertial measurement unit at a place p of a body reads.
///
///   f = A_v + A_w x p + w x (v + w x p)
///
/// the specific force, with A the body's proper acceleration; both readings in the unit's axes. In steps that look
/// ahead w is that at the end of the step, f the mean over it.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/math/spatial.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S>
struct InertialReading {
  Vec3<S> gyroscope, accelerometer;  ///< [rad/s], [m/s^2]
};

/// @param X_RI  the unit in the body's axes
/// @param h     length of a step that looks ahead, or 0 [s]
template <class S>
MUROSIMF_INLINE InertialReading<S> inertialReading(const KernelPose& X_RI, const SpatialMotion<S>& V,
                                                   const SpatialMotion<S>& A, S h) {
  const Transform<S> X = poseFrom<S>(X_RI);
  const Vec3<S>& p = X.translation;
  const Vec3<S> force = A.v + cross(A.w, p) + cross(V.w, V.v + cross(V.w, p));
  return {applyTransposed(X.rotation, V.w + A.w * h), applyTransposed(X.rotation, force)};
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
