#pragma once

/// @file Backlash: the play between a servo and its joint.
///
/// The servo comes to rest where it wants to be, and the joint is loose around that place by half the play to either
/// side: of an error e only what is beyond counts, e - clamp(e, -b/2, b/2), and the servo can push from there but not
/// pull. This is a rotor that crosses the play at once: at no-load speed it takes a servo 1 ms for 0.3 degrees. It
/// needs no memory of the side that it is on. The encoder counts as sitting on the servo's side of the play.

#include "murosimf/math/pack.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// What of an error is beyond the play b.
template <class S>
inline S beyondPlay(S error, S b) {
  const S half = S(0.5) * b;
  return error - clamp(error, -half, half);
}

/// Whether a torque would have to pull, or go through the play.
template <class S>
inline auto isLoose(S beyond, S torque) {
  return beyond * torque <= S(0);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
