#include "murosimf/modules/dynamics/prescribed_tree_motion_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<PrescribedTreeMotionArguments>& kernels) {
  kernels.eight = &prescribedTreeMotion<Pack<double, 8>>;
}

}  // namespace murosimf
