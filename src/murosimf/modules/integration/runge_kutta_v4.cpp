#include "murosimf/modules/integration/runge_kutta_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<RungeKuttaStage>& kernels) { kernels.eight = &rungeKuttaStage<Pack<double, 8>>; }

}  // namespace murosimf
