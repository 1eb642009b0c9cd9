#include "murosimf/modules/contact/pair_forces_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<PairForcesArguments>& kernels) { kernels.eight = &pairForces<Pack<double, 8>>; }

}  // namespace murosimf
