#pragma once

/// @file Kernel of simplified_dynamics.h.

#include "murosimf/algorithms/centroidal_motion.h"
#include "murosimf/algorithms/composite_motion.h"
#include "murosimf/algorithms/gravity.h"
#include "murosimf/algorithms/ground_fold.h"
#include "murosimf/linking/kernel.h"
#include "murosimf/math/bit_change.h"

namespace murosimf {

struct SimplifiedArguments {
  ArticulatedTree tree;
  bool recompute = true;  ///< version 2
  bool contacts = false;  ///< whether something may add inertia at contacts
  ColumnRef initial, inertia, q, dq, demand, base_pose, base_velocity;
  ColumnRef turn, twist, force, contact_touch, contact_inertia;
  ColumnRef composite, turn_ahead, position_ahead, velocity_ahead, slots, base_acceleration, step;
};

void addBaselineKernels(KernelSet<SimplifiedArguments>& kernels);
void addWideKernels(KernelSet<SimplifiedArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
struct SimplifiedColumns {
  const SimplifiedArguments& a;
  const S *q, *dq, *demand;
  const SinCos<S>* turn;
  const RigidInertia<S>* inertia;
  CompositeMotion<S>* slots;

  SimplifiedColumns(const SimplifiedArguments& arguments, const BlockMemory& block)
      : a(arguments),
        q(columnAt<S, S>(block, a.q)),
        dq(columnAt<S, S>(block, a.dq)),
        demand(columnAt<S, S>(block, a.demand)),
        turn(columnAt<SinCos<S>, S>(block, a.turn)),
        inertia(columnAt<RigidInertia<S>, S>(block, a.inertia)),
        slots(columnAt<CompositeMotion<S>, S>(block, a.slots)) {}
};

/// The composite of version 1: of the joints' first positions, without motion of theirs.
template <class S>
[[gnu::noinline]] CompositeMotion<S> firstComposite(const SimplifiedColumns<S>& c, const BlockMemory& block) {
  const S* first = columnAt<S, S>(block, c.a.initial);
  return compositeMotion<S>(
      c.a.tree, c.inertia, c.slots, [&](int i) { return jointTurn(c.a.tree.rows[i], first[i - 1]); },
      [](int) { return S(0); });
}
/// The composite of version 2, of the moment.
template <class S>
[[gnu::noinline]] CompositeMotion<S> presentComposite(const SimplifiedColumns<S>& c) {
  return compositeMotion<S>(
      c.a.tree, c.inertia, c.slots, [&](int i) { return c.turn[i - 1]; }, [&](int i) { return c.dq[i - 1]; });
}

template <class S>
inline CompositeMotion<S> select(decltype(S() < S()) mask, const CompositeMotion<S>& a, const CompositeMotion<S>& b) {
  return {{select(mask, a.inertia.m, b.inertia.m), select(mask, a.inertia.mc, b.inertia.mc),
           select(mask, a.inertia.I, b.inertia.I)},
          {select(mask, a.momentum.n, b.momentum.n), select(mask, a.momentum.f, b.momentum.f)}};
}

/// Makes the composite kept the one of the moment. It is that of the end of the last step, unless somebody has moved
/// joints since.
template <class S>
MUROSIMF_INLINE void refreshComposite(const SimplifiedColumns<S>& c, const BlockMemory& block,
                                      CompositeMotion<S>& kept) {
  auto stale = kept.inertia.m == S(0);
  if (c.a.recompute) {
    const S *q = columnAt<S, S>(block, c.a.position_ahead), *dq = columnAt<S, S>(block, c.a.velocity_ahead);
    BitChange<S> change;
    for (int j = 0; j + 1 < c.a.tree.bodies; ++j) change.see(q[j], c.q[j]), change.see(dq[j], c.dq[j]);
    stale = stale | change.found();
  }
  if (any(stale)) kept = select(stale, c.a.recompute ? presentComposite(c) : firstComposite(c, block), kept);
}

/// Goes on to the end of the step.
template <class S>
MUROSIMF_INLINE void advanceComposite(const SimplifiedColumns<S>& c, const BlockMemory& block, S h,
                                      CompositeMotion<S>& kept) {
  if (!c.a.recompute) return;
  const int joints = c.a.tree.bodies - 1;
  auto* ahead = columnAt<SinCos<S>, S>(block, c.a.turn_ahead);
  turnAhead(c.a.tree.rows, joints, c.turn, ahead, [&](int j) MUROSIMF_INLINE_LAMBDA { return h * c.demand[j]; });
  S *q = columnAt<S, S>(block, c.a.position_ahead), *dq = columnAt<S, S>(block, c.a.velocity_ahead);
  for (int j = 0; j < joints; ++j) q[j] = fma(h, c.demand[j], c.q[j]), dq[j] = c.demand[j];
  kept = compositeMotion<S>(
      c.a.tree, c.inertia, c.slots, [&](int i) MUROSIMF_INLINE_LAMBDA { return ahead[i - 1]; },
      [&](int i) MUROSIMF_INLINE_LAMBDA { return c.demand[i - 1]; });
}

/// What acts on the robot from outside.
template <class S>
MUROSIMF_INLINE BaseWrench<S> outerForces(const SimplifiedColumns<S>& c, const BlockMemory& block, S per_second) {
  const ArticulatedInertia<S>* none = nullptr;
  const GroundFold<S> fold{c.turn,
                           c.dq,
                           columnAt<SpatialMotion<S>, S>(block, c.a.twist),
                           columnAt<SpatialForce<S>, S>(block, c.a.force),
                           columnAt<S, S>(block, c.a.contact_touch),
                           c.a.contacts ? columnAt<ArticulatedInertia<S>, S>(block, c.a.contact_inertia) : none};
  return foldForces(c.a.tree.rows, c.a.tree.bodies, fold,
                    [&](int i) { return (c.demand[i - 1] - c.dq[i - 1]) * per_second; });
}

/// @param h       momentum about the base's origin at the beginning
/// @param centre  mass times centre of mass at the beginning
template <class S>
MUROSIMF_INLINE void fillStep(const Transform<S>& X_WB, const SpatialForce<S>& h, const Vec3<S>& centre,
                              const SpatialForce<S>& wrench, const CompositeMotion<S>& end, CentroidalStep<S>& step) {
  const Rotation<S>& R = X_WB.rotation;
  const S per_mass = S(1) / end.inertia.m;
  const Vec3<S> c = centre * per_mass;
  step.p = X_WB * c;
  step.v = R * (h.f * per_mass);
  step.L = R * (h.n - cross(c, h.f));
  step.force = R * wrench.f;
  step.force.z = fnma(S(kGravity), end.inertia.m, step.force.z);
  step.moment = R * (wrench.n - cross(c, wrench.f));
  step.mass = end.inertia.m;
  step.centre = end.inertia.mc * per_mass;
  step.centre_rate = end.momentum.f * per_mass;
  step.inertia = aboutCentre(end.inertia, step.centre);
  step.spin = end.momentum.n - cross(step.centre, end.momentum.f);
}

template <class S>
void simplifiedDynamics(const SimplifiedArguments& a, const BlockMemory& block, const StepTime& time) {
  const SimplifiedColumns<S> columns(a, block);
  auto& composite = *columnAt<CompositeMotion<S>, S>(block, a.composite);
  const SpatialMotion<S> V = *columnAt<SpatialMotion<S>, S>(block, a.base_velocity);
  const S h(time.dt), per_second(1 / time.dt);
  refreshComposite(columns, block, composite);
  const SpatialForce<S> momentum = composite.inertia * V + composite.momentum;
  const Vec3<S> centre = composite.inertia.mc;
  const BaseWrench<S> outer = outerForces(columns, block, per_second);
  advanceComposite(columns, block, h, composite);
  // What the joints' motion adds to the momentum, were the base to go on as it moves.
  const SpatialForce<S> change = composite.inertia * V + composite.momentum - momentum;
  ArticulatedInertia<S> inertia = articulated(composite.inertia);
  inertia += outer.inertia;
  const SpatialMotion<S> A = solved(inertia, outer.force - change * per_second - cross(V, momentum));
  *columnAt<SpatialMotion<S>, S>(block, a.base_acceleration) = A;
  fillStep(*columnAt<Transform<S>, S>(block, a.base_pose), momentum, centre, outer.force - outer.inertia * A, composite,
           *columnAt<CentroidalStep<S>, S>(block, a.step));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
