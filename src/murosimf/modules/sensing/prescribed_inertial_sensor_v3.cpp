#include "murosimf/modules/sensing/prescribed_inertial_sensor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<PrescribedInertialSensorArguments>& kernels) {
  kernels.scalar = &prescribedInertialSensor<double>;
  kernels.four = &prescribedInertialSensor<Pack<double, 4>>;
}

}  // namespace murosimf
