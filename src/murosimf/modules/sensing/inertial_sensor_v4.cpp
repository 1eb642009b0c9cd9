#include "murosimf/modules/sensing/inertial_sensor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<InertialSensorArguments>& kernels) { kernels.eight = &inertialSensor<Pack<double, 8>>; }

}  // namespace murosimf
