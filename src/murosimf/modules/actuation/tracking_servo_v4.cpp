#include "murosimf/modules/actuation/tracking_servo_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<TrackingServoArguments>& kernels) { kernels.eight = &trackingServo<Pack<double, 8>>; }

}  // namespace murosimf
