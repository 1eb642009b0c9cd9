#include "murosimf/modules/motion/kinematic_walking_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<KinematicWalkingArguments>& kernels) {
  kernels.scalar = &kinematicWalking<double>;
  kernels.four = &kinematicWalking<Pack<double, 4>>;
}

void adoptStance(const KinematicWalkingArguments& arguments, const BlockMemory& one) {
  adoptStanceFoot<double>(arguments, one);
}

}  // namespace murosimf
