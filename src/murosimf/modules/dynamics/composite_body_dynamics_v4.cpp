#include "murosimf/modules/dynamics/composite_body_dynamics_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<CompositeBodyArguments>& kernels) {
  kernels.eight = &compositeBodyDynamics<Pack<double, 8>>;
}

}  // namespace murosimf
