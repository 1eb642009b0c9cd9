#pragma once

/// @file Forces on the bodies of a tree whose joints move as prescribed, brought to its base.
///
/// A contact's force depends on the acceleration A of its body that it causes, f = f0 - K A (ground_contact.h). With
/// prescribed joints  A_i = X_i (A_0 + b_i), so all contacts together are one wrench and one inertia at the base:
///     W = sum X_i^T f0_i - K'_i b_i  -  (sum K'_i) A_0,   K'_i = X_i^T K_i X_i
/// b_i, in base axes, is what the joints between base and body contribute: sum X_j^-1 (V_j x S dq + S ddq).
/// One walk from the body to the base finds its pose there and b_i. Cost: about 35 multiplications and additions a
/// joint of the way, and 300 a body that touches.

#include "murosimf/algorithms/articulated_body.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Columns, one element a body unless said.
template <class S>
struct GroundFold {
  const SinCos<S>* turn = nullptr;                 ///< of each joint
  const S* joint_velocity = nullptr;               ///< of each joint
  const SpatialMotion<S>* velocity = nullptr;      ///< V
  const SpatialForce<S>* force = nullptr;          ///< f0
  const S* touch = nullptr;                        ///< > 0 where `inertia` holds
  const ArticulatedInertia<S>* inertia = nullptr;  ///< K; null: no contact has any
};

/// W = force - inertia A_0, in the base's axes about its origin.
template <class S>
struct BaseWrench {
  SpatialForce<S> force;
  ArticulatedInertia<S> inertia;
};

/// A body seen from a frame between it and the base, or from the base.
template <class S>
struct BodyOnTheWay {
  Rotation<S> R;          ///< its axes
  Vec3<S> p;              ///< its origin
  SpatialMotion<S> bias;  ///< b, of the joints so far
};

/// The same seen from a point from which the old origin lies at r along axis A [m].
template <int A, class S>
MUROSIMF_INLINE void shiftAlong(BodyOnTheWay<S>& a, S r) {
  constexpr int B = (A + 1) % 3, C = (A + 2) % 3;
  Vec3<S>&v = a.bias.v, &w = a.bias.w;
  component<A>(a.p) += r;
  component<B>(v) = fnma(r, component<C>(w), component<B>(v));
  component<C>(v) = fma(r, component<B>(w), component<C>(v));
}

/// From the axes of row k's body to those of its parent.
template <class S, class AccelerationOf>
MUROSIMF_INLINE void seeFromParent(const KernelRow* rows, int k, const GroundFold<S>& c,
                                   AccelerationOf&& accelerationOf, BodyOnTheWay<S>& a) {
  const KernelRow& row = rows[k];
  forJoint<S>(row, c.turn[k - 1], [&](const auto& joint) MUROSIMF_INLINE_LAMBDA {
    using Joint = std::remove_cvref_t<decltype(joint)>;
    constexpr int A = Joint::kAxis;
    add(a.bias, jointBias<Joint>(c.velocity[k], c.joint_velocity[k - 1]));
    joint.add(a.bias, accelerationOf(k));
    if constexpr (Joint::kPrismatic) {
      shiftAlong<A>(a, joint.turn.sin);
    } else {
      a.R = {turnedAbout<A>(a.R.x, joint.turn), turnedAbout<A>(a.R.y, joint.turn), turnedAbout<A>(a.R.z, joint.turn)};
      a.p = turnedAbout<A>(a.p, joint.turn);
      a.bias = {turnedAbout<A>(a.bias.w, joint.turn), turnedAbout<A>(a.bias.v, joint.turn)};
    }
  });
  if (row.turned) {
    const Rotation<S> R_PF = rotationFrom<S>(row.rotation);
    a.R = R_PF * a.R, a.p = R_PF * a.p;
    a.bias = {R_PF * a.bias.w, R_PF * a.bias.v};
  }
  if (row.translation[0] != 0) shiftAlong<0>(a, S(row.translation[0]));
  if (row.translation[1] != 0) shiftAlong<1>(a, S(row.translation[1]));
  if (row.translation[2] != 0) shiftAlong<2>(a, S(row.translation[2]));
}

/// Sums begin with +0 and only grow, so a body that adds nothing in some lanes leaves their bits alone.
template <class S, class AccelerationOf>
MUROSIMF_INLINE BaseWrench<S> foldForces(const KernelRow* rows, int bodies, const GroundFold<S>& c,
                                         AccelerationOf&& accelerationOf) {
  const S o(0);
  BaseWrench<S> sum{{{o, o, o}, {o, o, o}},
                    {{o, o, o, o, o, o}, {{{o, o, o}, {o, o, o}, {o, o, o}}}, {o, o, o, o, o, o}}};
  for (int i = 0; i < bodies; ++i) {
    const bool touches = c.inertia != nullptr && any(c.touch[i] > o);
    if (!touches && !anyBits(&c.force[i].n.x, 6)) continue;
    BodyOnTheWay<S> body{{}, {o, o, o}, {{o, o, o}, {o, o, o}}};
    for (int k = i; k > 0; k = rows[k].parent) seeFromParent(rows, k, c, accelerationOf, body);
    const Vec3<S> f = body.R * c.force[i].f;
    sum.force.f += f;
    sum.force.n += body.R * c.force[i].n + cross(body.p, f);
    if (!touches) continue;
    const ArticulatedInertia<S>& K = c.inertia[i];
    ArticulatedInertia<S> there{turned(body.R, K.I), turned(body.R, K.H), turned(body.R, K.M)};
    shiftAlong<0>(there, body.p.x), shiftAlong<1>(there, body.p.y), shiftAlong<2>(there, body.p.z);
    sum.inertia += there;
    sum.force = sum.force - there * body.bias;
  }
  return sum;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
