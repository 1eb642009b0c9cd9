#pragma once

/// @file What happens between two types of surface: constants of an unordered pair, and nothing else.
///
/// Normal force of one contact point, depth x > 0, separating speed u (u < 0 while approaching):
///     paper           f = s_c x (1 if u < 0, else s_b)                              [Friedmann 2007, eq. 1]
///     smooth          f = s_c x ((1 + s_b)/2 - (1 - s_b)/2 tanh(u / v_0))           the same without the jump
///     hunt_crossley   f = s_c x max(0, 1 - d u)                                     [Hunt & Crossley 1975]
/// Without gravity `paper` and `smooth` return the speed with the factor e = sqrt(s_b), whatever the speed.
///
/// Tangential force on A, u_t = (u_A - u_B) without its normal part:
///     coulomb   -mu f u_t / max(|u_t|, v_s)          dry friction, viscous below v_s
///     viscous   -s_mu f u_t                          [Friedmann 2007, eq. 2], projected on the tangent plane
/// Torque on A, w the relative angular velocity, r the radius of the rolling sphere:
///     -s_nu f w  -  c_rr f r w / max(|w|, v_s / r)   turning friction, and rolling resistance of constant size

#include <cstdint>

namespace murosimf {

enum class NormalLaw : std::uint8_t { kSmooth, kPaper, kHuntCrossley };
enum class FrictionLaw : std::uint8_t { kCoulomb, kViscous };

struct SurfacePair {
  NormalLaw normal_law = NormalLaw::kSmooth;
  FrictionLaw friction_law = FrictionLaw::kCoulomb;
  double stiffness = 3e3;           ///< s_c [N/m], > 0: force per metre of depth of the whole contact of two bodies
  double restitution_factor = 0.5;  ///< s_b in [0, 1]: share of the force left while separating
  double blend_speed = 0.02;        ///< v_0 [m/s], > 0: width of `smooth`'s passage from 1 to s_b
  double dissipation = 0.6;         ///< d [s/m], >= 0: `hunt_crossley` alone
  double friction = 0.5;            ///< mu, >= 0: `coulomb` alone
  double stick_speed = 2e-3;      ///< v_s [m/s], > 0: below it dry friction is viscous, so a slope creeps at v_s tan/mu
  double viscous_friction = 0;    ///< s_mu [s/m], >= 0: `viscous` alone
  double turning_friction = 0;    ///< s_nu [m s], >= 0
  double rolling_resistance = 0;  ///< c_rr, >= 0: a rolling ball slows by c_rr g / (1 + beta), I = beta m r^2
  friend bool operator==(const SurfacePair&, const SurfacePair&) = default;
};

}  // namespace murosimf
