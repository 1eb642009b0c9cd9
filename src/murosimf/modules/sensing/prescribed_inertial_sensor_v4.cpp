#include "murosimf/modules/sensing/prescribed_inertial_sensor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<PrescribedInertialSensorArguments>& kernels) {
  kernels.eight = &prescribedInertialSensor<Pack<double, 8>>;
}

}  // namespace murosimf
