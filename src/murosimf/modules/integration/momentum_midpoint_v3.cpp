#include "murosimf/modules/integration/momentum_midpoint_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<MomentumMidpointArguments>& kernels) {
  kernels.scalar = &momentumMidpoint<double>;
  kernels.four = &momentumMidpoint<Pack<double, 4>>;
}

}  // namespace murosimf
