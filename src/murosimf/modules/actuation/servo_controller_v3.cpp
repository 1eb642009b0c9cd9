#include "murosimf/modules/actuation/servo_controller_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<ServoControllerArguments>& kernels) {
  kernels.scalar = &controlServos<double>;
  kernels.four = &controlServos<Pack<double, 4>>;
}

}  // namespace murosimf
