#pragma once

/// @file What modules of full multibody dynamics share: multibody_dynamics.h and composite_body_dynamics.h.
///
/// Both take and give the same and find the same accelerations; any of them goes with every integrator, servo, contact
/// and sensor that the other goes with.

#include "murosimf/linking/module.h"
#include "murosimf/modules/dynamics/full_dynamics_kernel.h"

namespace murosimf {

class FullDynamics : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;

 protected:
  /// @return the tree whose columns it bound
  TreeTable bind(Links& links, FullDynamicsArguments& arguments);

 private:
  std::vector<KernelRow> rows_;
  GatherPlan gather_;
};

}  // namespace murosimf
