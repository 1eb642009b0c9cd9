#include "murosimf/modules/actuation/position_servo_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<PositionServoArguments>& kernels) {
  kernels.scalar = &positionServo<double>;
  kernels.four = &positionServo<Pack<double, 4>>;
}

}  // namespace murosimf
