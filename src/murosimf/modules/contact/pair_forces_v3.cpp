#include "murosimf/modules/contact/pair_forces_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<PairForcesArguments>& kernels) {
  kernels.scalar = &pairForces<double>;
  kernels.four = &pairForces<Pack<double, 4>>;
}

}  // namespace murosimf
