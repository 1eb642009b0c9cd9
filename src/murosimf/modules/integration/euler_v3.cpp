#include "murosimf/modules/integration/euler_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<EulerArguments>& kernels) {
  kernels.scalar = &advanceByEuler<double>;
  kernels.four = &advanceByEuler<Pack<double, 4>>;
}

}  // namespace murosimf
