#include "murosimf/modules/sensing/dynamic_inertial_sensor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<DynamicInertialSensorArguments>& kernels) {
  kernels.scalar = &dynamicInertialSensor<double>;
  kernels.four = &dynamicInertialSensor<Pack<double, 4>>;
}

}  // namespace murosimf
