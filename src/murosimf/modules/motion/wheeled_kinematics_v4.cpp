#include "murosimf/modules/motion/wheeled_kinematics_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<WheeledKinematicsArguments>& kernels) {
  kernels.eight = &wheeledKinematics<Pack<double, 8>>;
}

}  // namespace murosimf
