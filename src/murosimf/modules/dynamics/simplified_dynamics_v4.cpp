#include "murosimf/modules/dynamics/simplified_dynamics_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<SimplifiedArguments>& kernels) { kernels.eight = &simplifiedDynamics<Pack<double, 8>>; }

}  // namespace murosimf
