#include "murosimf/modules/integration/euler_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<EulerArguments>& kernels) { kernels.eight = &advanceByEuler<Pack<double, 8>>; }

}  // namespace murosimf
