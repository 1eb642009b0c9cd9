#include "murosimf/modules/dynamics/multibody_dynamics.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<JointResponse<double>> kJointResponse{"joint_response", "SI", "of the way inward", Storage::kStep};

}  // namespace

void MultibodyDynamics::declare(Declaration& d) const {
  FullDynamics::declare(d);
  d.adds(kJointResponse, subset::kJoints);
}

void MultibodyDynamics::link(Links& links) {
  bind(links, arguments_);
  arguments_.response = links.column(kJointResponse, subset::kJoints);
  kernel_ = kernelOfWidth<MultibodyArguments>(links.width());
}

}  // namespace murosimf
