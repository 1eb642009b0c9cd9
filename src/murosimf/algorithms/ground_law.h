#pragma once

/// @file Forces between the ground and a point of a body, linearised for steps that look ahead.
///
/// The laws are those of surface_pair.h. With depth x and separating speed u now, a step of length h that looks ahead
/// wants the force at its end, where u+ = u + h a and x+ = x - h u+, a the point's acceleration away from the ground:
///     f(x+, u+) = f(x - h u, u) - h (h df/dx - df/du) a + O(h^2)
/// so f at the predicted depth is the force, and what multiplies a counts as mass: the point pushes like a spring and
/// resists like an inertia, whatever the stiffness. `paper` freezes its factor. h = 0 gives the force as it is now.
/// Friction -c v_t, with c of the force so found, is taken at the step's end in the same way: mass h c, tangentially.

#include "murosimf/algorithms/surface_pair.h"
#include "murosimf/math/elementary.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// Normal force of a law with its slopes.
template <class S>
struct NormalForce {
  S force;     ///< [N]
  S by_depth;  ///< df/dx [N/m]
  S by_speed;  ///< -df/du >= 0 [N s/m]
};

/// @param k      stiffness of the point [N/m]
/// @param depth  x > 0
template <class S>
MUROSIMF_INLINE NormalForce<S> normalForce(const SurfacePair& pair, S k, S depth, S speed) {
  const S one(1), zero(0), spring = k * depth;
  if (pair.normal_law == NormalLaw::kHuntCrossley) {
    const S d(pair.dissipation), factor = max(fnma(d, speed, one), zero);
    return {spring * factor, k * factor, select(factor > zero, spring * d, zero)};
  }
  if (pair.normal_law == NormalLaw::kPaper) {
    const S factor = select(speed < zero, one, S(pair.restitution_factor));
    return {spring * factor, k * factor, zero};
  }
  const double mean = 0.5 * (1 + pair.restitution_factor), half = 0.5 * (1 - pair.restitution_factor);
  const S t = tanh(speed * S(1 / pair.blend_speed)), factor = fnma(S(half), t, S(mean));
  return {spring * factor, k * factor, spring * (S(half / pair.blend_speed) * fnma(t, t, one))};
}

/// c of the tangential force -c v_t that goes with a normal force [N s/m].
template <class S>
MUROSIMF_INLINE S tangentialDamping(const SurfacePair& pair, S normal_force, S tangential_speed) {
  if (pair.friction_law == FrictionLaw::kViscous) return S(pair.viscous_friction) * normal_force;
  return S(pair.friction) * normal_force / max(tangential_speed, S(pair.stick_speed));
}

/// What the ground does to a point of a body: force = constant - mass (a), a the point's acceleration.
template <class S>
struct GroundForce {
  S normal, damping;                   ///< f and c of the equations above
  S normal_mass{}, tangential_mass{};  ///< [kg]
};

/// @param touches  mask: where it is false, everything is zero
/// @param h        length of a step that looks ahead, or 0 [s]
template <class S, class Mask>
MUROSIMF_INLINE GroundForce<S> groundForce(const SurfacePair& pair, S k, Mask touches, S depth_ahead, S speed,
                                           S tangential_speed, S h) {
  const S zero(0);
  const NormalForce<S> law = normalForce(pair, k, select(touches, depth_ahead, zero), speed);
  GroundForce<S> result;
  result.normal = law.force;
  result.damping = tangentialDamping(pair, law.force, tangential_speed);
  result.normal_mass = select(touches, h * fma(h, law.by_depth, law.by_speed), zero);
  result.tangential_mass = h * result.damping;
  return result;
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
