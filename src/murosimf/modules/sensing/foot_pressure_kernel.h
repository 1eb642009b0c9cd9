#pragma once

/// @file Kernel of foot_pressure.h.

#include "murosimf/algorithms/corner_forces.h"
#include "murosimf/linking/kernel.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

/// A sole's body and the places of its four corners on it.
struct SoleCorners {
  int row = 0;
  double corner[4][3] = {};
};

struct FootPressureArguments {
  const SoleCorners* soles = nullptr;
  int count = 0;
  ColumnRef response, acceleration, up, pressure;
};

void addBaselineKernels(KernelSet<FootPressureArguments>& kernels);
void addWideKernels(KernelSet<FootPressureArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void footPressure(const FootPressureArguments& a, const BlockMemory& block, const StepTime&) {
  const auto* response = columnAt<CornerResponses<S>, S>(block, a.response);
  const auto* acceleration = columnAt<SpatialMotion<S>, S>(block, a.acceleration);
  const auto* up = columnAt<Vec3<S>, S>(block, a.up);
  auto* pressure = columnAt<CornerForces<S>, S>(block, a.pressure);
  for (int i = 0; i < a.count; ++i) {
    const SoleCorners& sole = a.soles[i];
    const SpatialMotion<S>& A = acceleration[sole.row];
    for (int k = 0; k < 4; ++k) {
      const double* r = sole.corner[k];
      const S along = dot(A.v + cross(A.w, Vec3<S>{S(r[0]), S(r[1]), S(r[2])}), up[sole.row]);
      pressure[i].of[k] = fnma(response[i].mass.of[k], along, response[i].force.of[k]);
    }
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
