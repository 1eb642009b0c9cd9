#include "murosimf/modules/actuation/tracking_servo_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<TrackingServoArguments>& kernels) {
  kernels.scalar = &trackingServo<double>;
  kernels.four = &trackingServo<Pack<double, 4>>;
}

}  // namespace murosimf
