#include "murosimf/modules/dynamics/multibody_dynamics_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<MultibodyArguments>& kernels) {
  kernels.scalar = &multibodyDynamics<double>;
  kernels.four = &multibodyDynamics<Pack<double, 4>>;
}

}  // namespace murosimf
