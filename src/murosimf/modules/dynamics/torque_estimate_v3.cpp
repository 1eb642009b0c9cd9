#include "murosimf/modules/dynamics/torque_estimate_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<TorqueEstimateArguments>& kernels) {
  kernels.scalar = &torqueEstimate<double>;
  kernels.four = &torqueEstimate<Pack<double, 4>>;
}

}  // namespace murosimf
