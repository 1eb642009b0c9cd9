#pragma once

/// @file Motion of a free rigid body over a substep: Newton's and Euler's laws in impulses.
///
/// v, w: velocity of the centre of mass and angular velocity, world axes. I_W = R diag(I) R^T. L = I_W w.
/// Orientation moves by the midpoint rule with the mean angular momentum,
///     R_mid = exp(h/2 [I_W^-1 L_mid]) R,   R+ = exp(h [I_mid^-1 L_mid]) R,   w+ = I+^-1 L+
/// so L is kept exactly, and energy to second order.

#include "murosimf/algorithms/contact_frame.h"

namespace murosimf {

inline bool isSpinningTop(const FreeBody& b) { return b.inertia.x != b.inertia.y || b.inertia.x != b.inertia.z; }

/// I_W^-1 t, I given by its principal moments on the axes of R_WB.
inline Vector3 applyInverseInertia(const FreeBody& b, const Rotation3& R_WB, const Vector3& t) {
  if (!isSpinningTop(b)) return t * (1 / b.inertia.x);
  const Vector3 t_B = applyTransposed(R_WB, t);
  return R_WB * Vector3{t_B.x / b.inertia.x, t_B.y / b.inertia.y, t_B.z / b.inertia.z};
}
inline Vector3 angularMomentum(const FreeBody& b) {
  const Vector3 w_B = applyTransposed(b.X_WB.rotation, b.angular_velocity);
  return b.X_WB.rotation * Vector3{b.inertia.x * w_B.x, b.inertia.y * w_B.y, b.inertia.z * w_B.z};
}
/// Velocity of the body's point at `arm` from the centre of mass, world axes.
inline Vector3 pointVelocity(const FreeBody& b, const Vector3& arm) {
  return b.velocity + cross(b.angular_velocity, arm);
}
/// Change of that velocity by an impulse at the same point.
inline Vector3 pointResponse(const FreeBody& b, const Vector3& arm, const Vector3& impulse) {
  return impulse * (1 / b.mass) + cross(applyInverseInertia(b, b.X_WB.rotation, cross(arm, impulse)), arm);
}
inline void applyAngularImpulse(FreeBody& b, const Vector3& angular_impulse) {
  b.angular_velocity += applyInverseInertia(b, b.X_WB.rotation, angular_impulse);
}
inline void applyImpulse(FreeBody& b, const Vector3& arm, const Vector3& impulse) {
  b.velocity += impulse * (1 / b.mass);
  applyAngularImpulse(b, cross(arm, impulse));
}

/// Velocity and angular momentum at a substep's start.
struct MotionStart {
  Vector3 velocity, angular_momentum;
};
inline MotionStart motionStart(const FreeBody& b) { return {b.velocity, angularMomentum(b)}; }

/// Moves the pose over dt, after the velocities have been moved there.
inline void advancePose(FreeBody& b, const MotionStart& start, double dt) {
  b.X_WB.translation += (start.velocity + b.velocity) * (0.5 * dt);
  const Rotation3 R = b.X_WB.rotation;
  const Vector3 L_end = angularMomentum(b), L_mid = (start.angular_momentum + L_end) * 0.5;
  Vector3 w_mid = applyInverseInertia(b, R, L_mid);
  if (isSpinningTop(b)) w_mid = applyInverseInertia(b, rotationExp(w_mid * (0.5 * dt)) * R, L_mid);
  b.X_WB.rotation = orthonormalized(rotationExp(w_mid * dt) * R);
  if (isSpinningTop(b)) b.angular_velocity = applyInverseInertia(b, b.X_WB.rotation, L_end);
}

}  // namespace murosimf
