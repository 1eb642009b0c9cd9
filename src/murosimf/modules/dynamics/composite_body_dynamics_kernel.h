#pragma once

/// @file Kernel of composite_body_dynamics.h.

#include "murosimf/algorithms/composite_body.h"
#include "murosimf/modules/dynamics/full_dynamics_kernel.h"

namespace murosimf {

struct CompositeBodyArguments : FullDynamicsArguments {
  const MatrixRow* matrix_rows = nullptr;
  ColumnRef matrix;
};

void addBaselineKernels(KernelSet<CompositeBodyArguments>& kernels);
void addWideKernels(KernelSet<CompositeBodyArguments>& kernels);

inline namespace MUROSIMF_ISA {

template <class S>
void compositeBodyDynamics(const CompositeBodyArguments& a, const BlockMemory& block, const StepTime& time) {
  addJointLoads<S>(a, block, time);
  const CompositeBody<S> columns{treeColumns<S>(a, block), a.matrix_rows, columnAt<S, S>(block, a.matrix)};
  compositeBody(a.tree, columns, ContactFold<S>(a, block));
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
