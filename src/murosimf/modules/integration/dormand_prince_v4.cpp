#include "murosimf/modules/integration/dormand_prince_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<DormandPrinceTask>& kernels) { kernels.eight = &dormandPrince<Pack<double, 8>>; }

}  // namespace murosimf
