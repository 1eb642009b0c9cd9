#include "murosimf/modules/dynamics/simplified_dynamics_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<SimplifiedArguments>& kernels) {
  kernels.scalar = &simplifiedDynamics<double>;
  kernels.four = &simplifiedDynamics<Pack<double, 4>>;
}

}  // namespace murosimf
