#include "murosimf/modules/actuation/gear_load_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<GearLoadArguments>& kernels) {
  kernels.scalar = &gearLoad<double>;
  kernels.four = &gearLoad<Pack<double, 4>>;
}

}  // namespace murosimf
