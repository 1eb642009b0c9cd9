#include "murosimf/modules/contact/ground_contact_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<GroundContactArguments>& kernels) {
  kernels.scalar = &groundContact<double>;
  kernels.four = &groundContact<Pack<double, 4>>;
}

}  // namespace murosimf
