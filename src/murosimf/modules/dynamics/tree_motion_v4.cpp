#include "murosimf/modules/dynamics/tree_motion_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<TreeMotionArguments>& kernels) { kernels.eight = &treeMotionPass<Pack<double, 8>>; }

}  // namespace murosimf
