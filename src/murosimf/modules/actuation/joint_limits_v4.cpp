#include "murosimf/modules/actuation/joint_limits_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<JointLimitArguments>& kernels) { kernels.eight = &jointLimits<Pack<double, 8>>; }

}  // namespace murosimf
