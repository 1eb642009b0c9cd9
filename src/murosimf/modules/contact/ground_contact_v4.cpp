#include "murosimf/modules/contact/ground_contact_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<GroundContactArguments>& kernels) { kernels.eight = &groundContact<Pack<double, 8>>; }

}  // namespace murosimf
