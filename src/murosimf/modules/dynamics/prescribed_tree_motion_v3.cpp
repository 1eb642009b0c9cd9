#include "murosimf/modules/dynamics/prescribed_tree_motion_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<PrescribedTreeMotionArguments>& kernels) {
  kernels.scalar = &prescribedTreeMotion<double>;
  kernels.four = &prescribedTreeMotion<Pack<double, 4>>;
}

}  // namespace murosimf
