#pragma once

/// @file A ServoCommand as kernels see it.

#include "murosimf/math/isa.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// The five numbers of a ServoCommand, one per lane.
template <class S>
struct CommandLanes {
  S position, velocity, torque, kp, kd;
};

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
