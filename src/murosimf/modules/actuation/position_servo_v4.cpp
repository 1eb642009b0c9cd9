#include "murosimf/modules/actuation/position_servo_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<PositionServoArguments>& kernels) { kernels.eight = &positionServo<Pack<double, 8>>; }

}  // namespace murosimf
