#pragma once

/// @file Kernel of force_sensor.h.

#include "murosimf/algorithms/joint_frame.h"
#include "murosimf/algorithms/solved_force.h"
#include "murosimf/linking/kernel.h"

namespace murosimf {

/// A body whose force passes through some sensor.
struct BodyBeyond {
  int row = 0;
  bool hands_on = false;  ///< its parent is another one
};

struct ForceSensorPlace {
  int row = 0;
  KernelPose X_RM;
};

struct ForceSensorArguments {
  const KernelRow* rows = nullptr;
  const BodyBeyond* beyond = nullptr;
  int bodies_beyond = 0;
  const ForceSensorPlace* places = nullptr;
  int sensors = 0;
  ColumnRef turn, inertia, twist, acceleration, force;
  bool contacts = false;  ///< whether something may add inertia at contacts
  ColumnRef contact_touch, contact_inertia, force_beyond, sensed;
};

void addBaselineKernels(KernelSet<ForceSensorArguments>& kernels);
void addWideKernels(KernelSet<ForceSensorArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// Force on body i from outside of the robot, of contacts what came of them.
template <class S>
inline Vec3<S> forceOn(const ForceSensorArguments& a, const BlockMemory& block, int i, const SpatialMotion<S>& A) {
  const SpatialForce<S>& force = columnAt<SpatialForce<S>, S>(block, a.force)[i];
  const auto touches = columnAt<S, S>(block, a.contact_touch)[i] > S(0);
  if (!a.contacts || !any(touches)) return force.f;
  return solvedForce(force, touches, columnAt<ArticulatedInertia<S>, S>(block, a.contact_inertia)[i], A).f;
}

/// m a_C, with gravity in it: body axes.
template <class S>
inline Vec3<S> rateOfMomentum(const RigidInertia<S>& body, const SpatialMotion<S>& V, const SpatialMotion<S>& A) {
  const Vec3<S> turning = cross(A.w, body.mc) + cross(V.w, cross(V.w, body.mc));
  return (A.v + cross(V.w, V.v)) * body.m + turning;
}

template <class S>
void forceSensor(const ForceSensorArguments& a, const BlockMemory& block, const StepTime&) {
  const auto* turn = columnAt<SinCos<S>, S>(block, a.turn);
  const auto* inertia = columnAt<RigidInertia<S>, S>(block, a.inertia);
  const auto* twist = columnAt<SpatialMotion<S>, S>(block, a.twist);
  const auto* acceleration = columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  auto *needed = columnAt<Vec3<S>, S>(block, a.force_beyond), *sensed = columnAt<Vec3<S>, S>(block, a.sensed);
  for (int k = 0; k < a.bodies_beyond; ++k) {
    const int i = a.beyond[k].row;
    const SpatialMotion<S>& A = acceleration[i];
    needed[i] = rateOfMomentum(inertia[i], twist[i], A) - forceOn(a, block, i, A);
  }
  for (int k = 0; k < a.bodies_beyond; ++k) {
    const int i = a.beyond[k].row;
    if (!a.beyond[k].hands_on) continue;
    forJoint<S>(a.rows[i], turn[i - 1], [&](const auto& joint) { needed[a.rows[i].parent] += joint.outOf(needed[i]); });
  }
  for (int k = 0; k < a.sensors; ++k) {
    const Rotation<S> R_RM = poseFrom<S>(a.places[k].X_RM).rotation;
    sensed[k] = -applyTransposed(R_RM, needed[a.places[k].row]);
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
