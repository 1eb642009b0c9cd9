#include "murosimf/modules/sensing/sensor_errors_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<SensorErrorsArguments>& kernels) {
  kernels.scalar = &sensorErrors<double>;
  kernels.four = &sensorErrors<Pack<double, 4>>;
}

}  // namespace murosimf
