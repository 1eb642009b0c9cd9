#include "murosimf/modules/motion/wheeled_kinematics_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<WheeledKinematicsArguments>& kernels) {
  kernels.scalar = &wheeledKinematics<double>;
  kernels.four = &wheeledKinematics<Pack<double, 4>>;
}

}  // namespace murosimf
