#include "murosimf/modules/dynamics/multibody_dynamics_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<MultibodyArguments>& kernels) { kernels.eight = &multibodyDynamics<Pack<double, 8>>; }

}  // namespace murosimf
