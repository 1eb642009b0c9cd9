#include "murosimf/modules/sensing/joint_torque_sensor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<JointTorqueSensorArguments>& kernels) {
  kernels.eight = &jointTorqueSensor<Pack<double, 8>>;
}

}  // namespace murosimf
