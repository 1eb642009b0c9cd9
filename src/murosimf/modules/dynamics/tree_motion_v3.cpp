#include "murosimf/modules/dynamics/tree_motion_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<TreeMotionArguments>& kernels) {
  kernels.scalar = &treeMotionPass<double>;
  kernels.four = &treeMotionPass<Pack<double, 4>>;
}

}  // namespace murosimf
