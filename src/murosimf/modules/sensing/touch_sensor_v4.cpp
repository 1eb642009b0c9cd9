#include "murosimf/modules/sensing/touch_sensor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<TouchSensorArguments>& kernels) { kernels.eight = &touchSensor<Pack<double, 8>>; }

}  // namespace murosimf
