#include "murosimf/modules/actuation/ideal_servo_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<IdealServoArguments>& kernels) {
  kernels.scalar = &idealServo<double>;
  kernels.four = &idealServo<Pack<double, 4>>;
}

}  // namespace murosimf
