#include "murosimf/modules/actuation/joint_limits_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<JointLimitArguments>& kernels) {
  kernels.scalar = &jointLimits<double>;
  kernels.four = &jointLimits<Pack<double, 4>>;
}

}  // namespace murosimf
