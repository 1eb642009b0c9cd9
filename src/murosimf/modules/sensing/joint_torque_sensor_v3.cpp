#include "murosimf/modules/sensing/joint_torque_sensor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<JointTorqueSensorArguments>& kernels) {
  kernels.scalar = &jointTorqueSensor<double>;
  kernels.four = &jointTorqueSensor<Pack<double, 4>>;
}

}  // namespace murosimf
