#include "murosimf/modules/kinematics/body_poses_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<PostureArguments>& kernels) {
  kernels.scalar = &keepPostures<double>;
  kernels.four = &keepPostures<Pack<double, 4>>;
}

void addBaselineKernels(KernelSet<BodyPosesArguments>& kernels) {
  kernels.scalar = &bodyPoses<double>;
  kernels.four = &bodyPoses<Pack<double, 4>>;
}

}  // namespace murosimf
