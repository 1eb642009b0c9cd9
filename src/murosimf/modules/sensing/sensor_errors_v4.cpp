#include "murosimf/modules/sensing/sensor_errors_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<SensorErrorsArguments>& kernels) { kernels.eight = &sensorErrors<Pack<double, 8>>; }

}  // namespace murosimf
