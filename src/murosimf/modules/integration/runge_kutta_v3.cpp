#include "murosimf/modules/integration/runge_kutta_kernel.h"

namespace murosimf {

void addBaselineKernels(KernelSet<RungeKuttaStage>& kernels) {
  kernels.scalar = &rungeKuttaStage<double>;
  kernels.four = &rungeKuttaStage<Pack<double, 4>>;
}

}  // namespace murosimf
