#pragma once

/// @file Normal forces on the four corners of a sole, in the order (-x -y), (+x -y), (-x +y), (+x +y).

#include "murosimf/math/isa.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

template <class S = double>
struct CornerForces {
  S of[4]{};  ///< [N]
};

/// Before the dynamics is solved: each corner's is `force` less `mass` times the corner's proper acceleration along up.
template <class S = double>
struct CornerResponses {
  CornerForces<S> force, mass;
};

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
