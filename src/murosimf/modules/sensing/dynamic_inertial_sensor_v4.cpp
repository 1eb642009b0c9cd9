#include "murosimf/modules/sensing/dynamic_inertial_sensor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<DynamicInertialSensorArguments>& kernels) {
  kernels.eight = &dynamicInertialSensor<Pack<double, 8>>;
}

}  // namespace murosimf
