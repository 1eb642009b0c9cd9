#include "murosimf/modules/dynamics/composite_body_dynamics_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<CompositeBodyArguments>& kernels) {
  kernels.scalar = &compositeBodyDynamics<double>;
  kernels.four = &compositeBodyDynamics<Pack<double, 4>>;
}

}  // namespace murosimf
