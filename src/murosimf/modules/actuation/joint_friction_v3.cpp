#include "murosimf/modules/actuation/joint_friction_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<JointFrictionArguments>& kernels) {
  kernels.scalar = &jointFriction<double>;
  kernels.four = &jointFriction<Pack<double, 4>>;
}

}  // namespace murosimf
