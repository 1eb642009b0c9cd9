#include "murosimf/modules/sensing/touch_sensor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<TouchSensorArguments>& kernels) {
  kernels.scalar = &touchSensor<double>;
  kernels.four = &touchSensor<Pack<double, 4>>;
}

}  // namespace murosimf
