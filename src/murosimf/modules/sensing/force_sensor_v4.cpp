#include "murosimf/modules/sensing/force_sensor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<ForceSensorArguments>& kernels) { kernels.eight = &forceSensor<Pack<double, 8>>; }

}  // namespace murosimf
