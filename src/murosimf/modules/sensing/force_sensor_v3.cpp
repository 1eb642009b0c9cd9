#include "murosimf/modules/sensing/force_sensor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<ForceSensorArguments>& kernels) {
  kernels.scalar = &forceSensor<double>;
  kernels.four = &forceSensor<Pack<double, 4>>;
}

}  // namespace murosimf
