#include "murosimf/modules/actuation/servo_controller_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<ServoControllerArguments>& kernels) { kernels.eight = &controlServos<Pack<double, 8>>; }

}  // namespace murosimf
