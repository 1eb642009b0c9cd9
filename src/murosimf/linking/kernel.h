#pragma once

/// @file How kernels reach columns, and how a module picks the kernel of its lane width.
///
/// A kernel is a function template on the scalar S in a `*_kernel.h` file, instantiated once for double and
/// Pack<double, 4> (`*_v3.cpp`) and once for Pack<double, 8> (`*_v4.cpp`).

#include "murosimf/linking/block_memory.h"
#include "murosimf/math/transform.h"

namespace murosimf {
inline namespace MUROSIMF_ISA {

/// First element of a column; T is made of S: S itself, Vec3<S>, Rotation<S>, Transform<S>.
template <class T, class S>
inline T* columnAt(const BlockMemory& memory, ColumnRef column) {
  constexpr int kWidth = static_cast<int>(sizeof(S) / sizeof(double));
  return reinterpret_cast<T*>(memory.piece[static_cast<int>(column.memory)] + column.offset * kWidth);
}

}  // namespace MUROSIMF_ISA

/// The versions of one kernel. All give the same bits.
template <class Arguments>
struct KernelSet {
  using Kernel = void (*)(const Arguments&, const BlockMemory&, const StepTime&);
  Kernel scalar = nullptr, four = nullptr, eight = nullptr;
};

/// The kernel for this lane width. For each type of arguments, the `*_v3.cpp` file defines
/// `void addBaselineKernels(KernelSet<Arguments>&)` and the `*_v4.cpp` file `void addWideKernels(...)`.
template <class Arguments>
typename KernelSet<Arguments>::Kernel kernelOfWidth(int width) {
  KernelSet<Arguments> kernels;
  addBaselineKernels(kernels);
  addWideKernels(kernels);
  return width == 1 ? kernels.scalar : width == 4 ? kernels.four : kernels.eight;
}

}  // namespace murosimf
