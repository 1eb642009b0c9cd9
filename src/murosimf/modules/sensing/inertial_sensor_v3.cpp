#include "murosimf/modules/sensing/inertial_sensor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<InertialSensorArguments>& kernels) {
  kernels.scalar = &inertialSensor<double>;
  kernels.four = &inertialSensor<Pack<double, 4>>;
}

}  // namespace murosimf
