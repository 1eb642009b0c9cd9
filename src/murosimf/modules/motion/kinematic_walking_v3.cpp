#include "murosimf/modules/motion/kinematic_walking_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<KinematicWalkingArguments>& kernels) {
  kernels.scalar = &kinematicWalking<double>;
  kernels.four = &kinematicWalking<Pack<double, 4>>;
}

}  // namespace murosimf
