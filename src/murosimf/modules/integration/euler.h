#pragma once

/// @file Euler's methods that move with the velocity at the end of the step.
///
/// Model      V+ = V + h a,   q+ = q + h V+,   X_WB+ = X_WB moved by h V+, with the base's V as seen from the world.
///            implicit_euler       a of forces that look ahead: as they will be with V+, linearised; what makes a servo
///                                 or a contact stiff then counts as inertia added at joint and contact point. The
///                                 default of multibody dynamics.
///            semi_implicit_euler  a of forces as they are now; the default of simplified dynamics.
/// Order      1.
/// Adds       joint_position, joint_velocity, base_pose, base_velocity; step_manner.
/// Cost       one evaluation and about 10 operations a joint.
/// Exchange   with any other integrator.

#include "murosimf/linking/fixed_value.h"
#include "murosimf/linking/integrator.h"
#include "murosimf/modules/integration/euler_kernel.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class EulerIntegrator : public Integrator {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override { manner_.adopt(one); }
  void step(const BlockMemory& block, const StepTime& time) const override;

 protected:
  explicit EulerIntegrator(bool looks_ahead) : looks_ahead_(looks_ahead) {}

 private:
  bool looks_ahead_;
  EulerArguments arguments_;
  FixedValue<StepManner> manner_{kStepManner, {1, 0}};
  ColumnRef initial_;
  int width_ = 1;
  KernelSet<EulerArguments>::Kernel advance_ = nullptr;
};

class ImplicitEuler final : public EulerIntegrator {
 public:
  ImplicitEuler() : EulerIntegrator(true) {}
};
class SemiImplicitEuler final : public EulerIntegrator {
 public:
  SemiImplicitEuler() : EulerIntegrator(false) {}
};

}  // namespace murosimf
