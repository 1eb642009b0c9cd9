#include "murosimf/modules/sensing/foot_pressure_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<FootPressureArguments>& kernels) { kernels.eight = &footPressure<Pack<double, 8>>; }

}  // namespace murosimf
