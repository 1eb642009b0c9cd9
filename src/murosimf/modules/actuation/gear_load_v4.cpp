#include "murosimf/modules/actuation/gear_load_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<GearLoadArguments>& kernels) { kernels.eight = &gearLoad<Pack<double, 8>>; }

}  // namespace murosimf
