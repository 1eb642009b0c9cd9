#include "murosimf/modules/integration/dormand_prince_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<DormandPrinceTask>& kernels) {
  kernels.scalar = &dormandPrince<double>;
  kernels.four = &dormandPrince<Pack<double, 4>>;
}

}  // namespace murosimf
