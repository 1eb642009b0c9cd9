#include "murosimf/modules/dynamics/body_accelerations_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<BodyAccelerationsArguments>& kernels) {
  kernels.eight = &bodyAccelerations<Pack<double, 8>>;
}

}  // namespace murosimf
