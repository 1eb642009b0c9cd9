#include "murosimf/modules/actuation/dc_motor_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<DcMotorArguments>& kernels) { kernels.eight = &dcMotor<Pack<double, 8>>; }

}  // namespace murosimf
