#include "murosimf/modules/sensing/foot_pressure_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<FootPressureArguments>& kernels) {
  kernels.scalar = &footPressure<double>;
  kernels.four = &footPressure<Pack<double, 4>>;
}

}  // namespace murosimf
