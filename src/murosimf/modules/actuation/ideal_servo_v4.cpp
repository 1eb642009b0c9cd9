#include "murosimf/modules/actuation/ideal_servo_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<IdealServoArguments>& kernels) { kernels.eight = &idealServo<Pack<double, 8>>; }

}  // namespace murosimf
