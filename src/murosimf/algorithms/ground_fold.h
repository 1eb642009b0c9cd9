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

/// From the axes of row k's body to those of its parent.
template <class S, class AccelerationOf>
MUROSIMF_INLINE void step(const KernelRow* rows, int k, const GroundFold<S>& c, AccelerationOf&& accelerationOf,
                          BodyOnTheWay<S>& a) {
  const KernelRow& row = rows[k];
  forJoint<S>(row, c.turn[k - 1], [&](const auto& joint) MUROSIMF_INLINE_LAMBDA {
    using Joint = std::remove_cvref_t<decltype(joint)>;
    constexpr int A = Joint::kAxis;
    add(a.bias, jointBias<Joint>(c.velocity[k], c.joint_velocity[k - 1]));
    joint.add(a.bias, accelerationOf(k));
    if constexpr (Joint::kPrismatic) {
      component<A>(a.p) += joint.turn.sin;
      Vec3<S> way{S(0), S(0), S(0)};
      component<A>(way) = joint.turn.sin;
      a.bias.v += cross(way, a.bias.w);
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
  const double* t = row.translation;
  Vec3<S>&v = a.bias.v, &w = a.bias.w;
  if (t[0] != 0) a.p.x += S(t[0]), v.y = fnma(S(t[0]), w.z, v.y), v.z = fma(S(t[0]), w.y, v.z);
  if (t[1] != 0) a.p.y += S(t[1]), v.z = fnma(S(t[1]), w.x, v.z), v.x = fma(S(t[1]), w.z, v.x);
  if (t[2] != 0) a.p.z += S(t[2]), v.x = fnma(S(t[2]), w.y, v.x), v.y = fma(S(t[2]), w.x, v.y);
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
    for (int k = i; k > 0; k = rows[k].parent) step(rows, k, c, accelerationOf, body);
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
