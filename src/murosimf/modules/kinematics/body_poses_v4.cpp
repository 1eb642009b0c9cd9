#include "murosimf/modules/kinematics/body_poses_kernel.h"

namespace murosimf {

void addWideKernels(KernelSet<PostureArguments>& kernels) { kernels.eight = &keepPostures<Pack<double, 8>>; }
void addWideKernels(KernelSet<BodyPosesArguments>& kernels) { kernels.eight = &bodyPoses<Pack<double, 8>>; }

}  // namespace murosimf
