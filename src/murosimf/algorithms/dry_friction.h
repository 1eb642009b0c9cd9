#pragma once

/// @file Dry friction of a joint, for steps that look ahead.
///
///   tau = -f w / max(|w|, w_s)          f: its size [N m], w: velocity [rad/s], w_s: stick speed
///
/// Coulomb's law, made continuous below w_s: a joint that is held by friction creeps with w_s tau/f. For a step h that
/// looks ahead the w above the line is the one at its end, w + h dw/dt, and that below it the one expected there, as
/// far again as the joint came in the last step; what depends on dw/dt counts as inertia h f / max(|w|, w_s) at the
/// joint. Then friction of any size stops a joint and never turns it back, whatever h is. A joint that breaks loose
/// needs some steps until the expected speed has grown to the true one, the more the less its drive exceeds the
/// friction.
///
/// The Stribeck effect, that friction is largest at rest: share exp(-|w/w_c|^a) [Armstrong-Hélouvry et al. 1994].

#include "murosimf/math/elementary.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// A torque, and what of it depends on the acceleration, as inertia.
template <class S>
struct ImplicitTorque {
  S torque, inertia;
};

/// The speed to expect at the end of a step; that of the moment where the joint is about to turn round.
template <class S>
inline S expectedSpeed(S w, S w_last) {
  const S ahead = fma(S(2), w, -w_last);
  return abs(select(ahead * w > S(0), ahead, w));
}

/// @param f >= 0 [N m]  @param w_last one step ago  @param h 0: the torque as it is now
template <class S>
inline ImplicitTorque<S> dryFriction(S f, S w, S w_last, S stick_speed, double h) {
  const S slope = f / max(h > 0 ? expectedSpeed(w, w_last) : abs(w), stick_speed);
  return {-(slope * w), S(h) * slope};
}

/// exp(-|w/w_c|^a), 1 at rest. @param speed w_c > 0 [rad/s]  @param exponent a > 0
template <class S>
inline S stribeckShare(S w, S speed, S exponent) {
  const S ratio = max(abs(w) / speed, S(1e-30));
  return exp(-exp(exponent * log(ratio)));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
