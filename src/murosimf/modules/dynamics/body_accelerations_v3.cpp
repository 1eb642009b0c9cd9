#include "murosimf/modules/dynamics/body_accelerations_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<BodyAccelerationsArguments>& kernels) {
  kernels.scalar = &bodyAccelerations<double>;
  kernels.four = &bodyAccelerations<Pack<double, 4>>;
}

}  // namespace murosimf
