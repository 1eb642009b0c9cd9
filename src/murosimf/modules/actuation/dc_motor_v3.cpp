#include "murosimf/modules/actuation/dc_motor_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<DcMotorArguments>& kernels) {
  kernels.scalar = &dcMotor<double>;
  kernels.four = &dcMotor<Pack<double, 4>>;
}

}  // namespace murosimf
