#include "murosimf/modules/actuation/joint_friction_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<JointFrictionArguments>& kernels) { kernels.eight = &jointFriction<Pack<double, 8>>; }

}  // namespace murosimf
