#pragma once

/// @file Kernel of wheeled_kinematics.h; the equations stand there and in algorithms/wheel_slip.h.

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/algorithms/wheel_slip.h"
#include "murosimf/linking/kernel.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

struct WheeledKinematicsArguments {
  const KernelRow* rows = nullptr;
  int bodies = 0;
  const PlanarWheel* wheels = nullptr;
  int count = 0;
  double height = 0;  ///< of the base's origin over the ground [m]
  ColumnRef q, dq, demand, base_pose, base_velocity;
  ColumnRef pair_touch, pair_force;
  ColumnRef body;  ///< PlanarBody
  ColumnRef load, friction, stick_speed, creepage, slip;
};

void addBaselineKernels(KernelSet<WheeledKinematicsArguments>& kernels);
void addWideKernels(KernelSet<WheeledKinematicsArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// What pushes the bodies, in the base's axes about its origin; joints as they are at the step's end.
template <class S>
inline SpatialForce<S> outerPush(const WheeledKinematicsArguments& a, const BlockMemory& block, const S* q) {
  const auto* force = columnAt<SpatialForce<S>, S>(block, a.pair_force);
  SpatialForce<S> sum = force[0];
  for (int i = 1; i < a.bodies; ++i) {
    if (!anyBits(&force[i].n.x, 6)) continue;
    SpatialForce<S> there = force[i];
    for (int row = i; row > 0; row = a.rows[row].parent) {
      const Transform<S> X = childPose(Transform<S>{}, a.rows[row], q[row - 1]);
      const Vec3<S> f = X.rotation * there.f;
      there = {X.rotation * there.n + cross(X.translation, f), f};
    }
    sum += there;
  }
  return sum;
}

/// v turned by an angle about z.
template <class S>
inline Slip<S> turnedBy(const SinCos<S>& angle, S x, S y) {
  return {fma(angle.cos, x, -(angle.sin * y)), fma(angle.sin, x, angle.cos * y)};
}

/// The base goes along the arc that its velocity, constant in its axes, draws in the step.
template <class S>
inline void advanceBase(const WheeledKinematicsArguments& a, const BlockMemory& block, S vx, S vy, S turn, S h) {
  auto& X_WB = *columnAt<Transform<S>, S>(block, a.base_pose);
  const S heading = atan2(X_WB.rotation.x.y, X_WB.rotation.x.x), half = S(0.5) * h * turn;
  const auto turns = abs(half) > S(1e-9);
  const S chord = select(turns, sincos(half).sin / select(turns, half, S(1)), S(1));
  const Slip<S> way = turnedBy(sincos(heading + half), h * chord * vx, h * chord * vy);
  X_WB.rotation = rotationZ(fma(h, turn, heading));
  X_WB.translation = {X_WB.translation.x + way.x, X_WB.translation.y + way.y, S(a.height)};
  *columnAt<SpatialMotion<S>, S>(block, a.base_velocity) = {{S(0), S(0), turn}, {vx, vy, S(0)}};
}

template <class S>
inline void tellSlip(const WheeledKinematicsArguments& a, const BlockMemory& block, int i, const Slip<S>& s) {
  const PlanarWheel& wheel = a.wheels[i];
  const S along = fma(s.x, S(wheel.roller_x), s.y * S(wheel.roller_y));
  columnAt<S, S>(block, a.slip)[i] = wheel.rollers ? abs(along) : sqrt(fma(s.x, s.x, s.y * s.y));
}

template <class S>
void wheeledKinematics(const WheeledKinematicsArguments& a, const BlockMemory& block, const StepTime& time) {
  const S h(time.dt), per_step(1 / time.dt);
  S *q = columnAt<S, S>(block, a.q), *dq = columnAt<S, S>(block, a.dq);
  const S* demand = columnAt<S, S>(block, a.demand);
  for (int j = 0; j + 1 < a.bodies; ++j) {
    dq[j] = demand[j];
    q[j] = fma(h, demand[j], q[j]);
  }
  const auto& body = *columnAt<PlanarBody<S>, S>(block, a.body);
  const SpatialMotion<S> V = *columnAt<SpatialMotion<S>, S>(block, a.base_velocity);
  const Slip<S> moved =
      turnedBy(sincos(-(h * V.w.z)), fnma(V.w.z, body.centre_y, V.v.x), fma(V.w.z, body.centre_x, V.v.y));
  PlanarMotion<S> push{S(0), S(0), S(0)};
  if (any(*columnAt<S, S>(block, a.pair_touch) > S(0))) {
    const SpatialForce<S> F = outerPush(a, block, q);
    push = {h * F.f.x, h * F.f.y, h * (F.n.z - fma(body.centre_x, F.f.y, -(body.centre_y * F.f.x)))};
  }
  const S *load = columnAt<S, S>(block, a.load), *friction = columnAt<S, S>(block, a.friction);
  const S *stick = columnAt<S, S>(block, a.stick_speed), *creepage = columnAt<S, S>(block, a.creepage);
  const auto gripOf = [&](int i) {
    const PlanarWheel& wheel = a.wheels[i];
    const S rolling = wheel.joint >= 0 ? S(wheel.radius) * demand[wheel.joint] : S(0);
    return WheelGrip<S>{S(wheel.x) - body.centre_x, S(wheel.y) - body.centre_y, rolling, friction[i] * load[i],
                        fma(creepage[i], abs(rolling), stick[i])};
  };
  const PlanarMotion<S> u =
      planarVelocity(a.wheels, a.count, body, PlanarMotion<S>{moved.x, moved.y, V.w.z}, push, per_step, gripOf);
  for (int i = 0; i < a.count; ++i) tellSlip(a, block, i, slipOf(a.wheels[i], gripOf(i), u));
  advanceBase(a, block, fma(u.turn, body.centre_y, u.x), fnma(u.turn, body.centre_x, u.y), u.turn, h);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
