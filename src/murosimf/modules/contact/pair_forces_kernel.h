#pragma once

/// @file Kernel of pair_forces.h.

#include "murosimf/linking/kernel.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

struct PairForcesArguments {
  int bodies = 0;
  ColumnRef touch, pair_force, force;
};

void addBaselineKernels(KernelSet<PairForcesArguments>& kernels);
void addWideKernels(KernelSet<PairForcesArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void pairForces(const PairForcesArguments& a, const BlockMemory& block, const StepTime&) {
  if (!any(*columnAt<S, S>(block, a.touch) > S(0))) return;
  const auto* pair_force = columnAt<SpatialForce<S>, S>(block, a.pair_force);
  auto* force = columnAt<SpatialForce<S>, S>(block, a.force);
  for (int i = 0; i < a.bodies; ++i) force[i] += pair_force[i];
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
