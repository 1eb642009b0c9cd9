#pragma once

/// @file Kernel of multibody_dynamics.h.

#include "murosimf/algorithms/articulated_body.h"
#include "murosimf/modules/dynamics/full_dynamics_kernel.h"

namespace murosimf {

struct MultibodyArguments : FullDynamicsArguments {
  ColumnRef response;
};

void addBaselineKernels(KernelSet<MultibodyArguments>& kernels);
void addWideKernels(KernelSet<MultibodyArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void multibodyDynamics(const MultibodyArguments& a, const BlockMemory& block, const StepTime& time) {
  addJointLoads<S>(a, block, time);
  const ArticulatedBody<S> columns{treeColumns<S>(a, block), columnAt<JointResponse<S>, S>(block, a.response)};
  articulatedInward(a.tree, columns, ContactFold<S>(a, block));
  articulatedOutward(a.tree, columns);
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
