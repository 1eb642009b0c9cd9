#pragma once

/// @file Dry friction in the gear of a servo, which grows with what the gear carries [Duclusaud et al. 2025].
///
///   f = K_c + |K_m t_m - K_e t_e| + s(w) (K_cs + |K_ms t_m - K_es t_e| + Q),   s(w) = exp(-|w/w_s|^a)
///   Q = K_eq t_e^2 where |t_m| > |t_e|, else K_mq t_m^2; only where t_m and t_e have opposite signs
///
/// t_m: torque of the motor, t_e: torque from outside, both seen at the joint [N m]; w: velocity of the joint [rad/s].
/// This is the source's model M6. M5 has no Q; M4 has K_m = K_e and K_ms = K_es; M3 has no Stribeck terms; M2 no load
/// terms; M1 neither. Viscous friction, K_v w, which all of them have, is not part of f.

#include "murosimf/algorithms/dry_friction.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// The parameters, all >= 0. T: a number, lanes of it, or where to find it.
template <class T>
struct GearFriction {
  T base;                                 ///< K_c [N m]
  T stribeck;                             ///< K_cs [N m]
  T motor_load, external_load;            ///< K_m, K_e
  T motor_stribeck, external_stribeck;    ///< K_ms, K_es
  T motor_quadratic, external_quadratic;  ///< K_mq, K_eq [1/(N m)]
  T speed;                                ///< w_s [rad/s], > 0
  T exponent;                             ///< a, > 0

  /// The same with every parameter turned into another type.
  template <class Turn>
  auto mapped(Turn&& turn) const {
    using U = decltype(turn(base));
    return GearFriction<U>{
        turn(base),           turn(stribeck),          turn(motor_load),      turn(external_load),
        turn(motor_stribeck), turn(external_stribeck), turn(motor_quadratic), turn(external_quadratic),
        turn(speed),          turn(exponent)};
  }
};

/// f [N m].
template <class S>
inline S gearFriction(const GearFriction<S>& g, S t_m, S t_e, S w) {
  const S zero(0);
  S f = g.base + abs(fnma(g.external_load, t_e, g.motor_load * t_m));
  const auto sticky =
      g.stribeck + g.motor_stribeck + g.external_stribeck + g.motor_quadratic + g.external_quadratic > zero;
  if (!any(sticky)) return f;
  const S load = abs(fnma(g.external_stribeck, t_e, g.motor_stribeck * t_m));
  const S quadratic = select(abs(t_m) > abs(t_e), g.external_quadratic * (t_e * t_e), g.motor_quadratic * (t_m * t_m));
  const S at_rest = g.stribeck + load + select(t_m * t_e < zero, quadratic, zero);
  return select(sticky, fma(stribeckShare(w, g.speed, g.exponent), at_rest, f), f);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
