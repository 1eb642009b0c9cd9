#include "murosimf/modules/dynamics/torque_estimate_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<TorqueEstimateArguments>& kernels) { kernels.eight = &torqueEstimate<Pack<double, 8>>; }

}  // namespace murosimf
