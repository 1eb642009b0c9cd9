#include "murosimf/modules/integration/momentum_midpoint_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<MomentumMidpointArguments>& kernels) {
  kernels.eight = &momentumMidpoint<Pack<double, 8>>;
}

}  // namespace murosimf
