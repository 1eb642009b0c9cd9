#include "murosimf/modules/motion/kinematic_walking_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<KinematicWalkingArguments>& kernels) {
  kernels.eight = &kinematicWalking<Pack<double, 8>>;
}

}  // namespace murosimf
