#pragma once

/// @file Explicit methods of fixed step: explicit Euler, midpoint, and the classical method of order 4.
///
/// Model      y' = f(y) with y the joints' positions and rates and the base's pose and velocity; stage i is evaluated
/// at
///            y_0 + h a_i k_(i-1), the step ends at y_0 + h sum b_i k_i:
///                explicit_euler  b = 1                              order 1
///                midpoint        a = 1/2, b = 0, 1                  order 2
///                runge_kutta_4   a = 1/2, 1/2, 1, b = 1/6 1/3 1/3 1/6   order 4 [Hairer, Norsett, Wanner 1993, II.1]
///            Rotations are stepped in a chart of their own (base_chart.h), so the order holds for them too.
/// Forces     are asked for as they are now, without the look ahead of implicit steps: servos and grounds that are
/// stiff
///            for the step make these methods diverge.
/// Adds       joint_position, joint_velocity, base_pose, base_velocity; step_manner.
/// Cost       one evaluation a stage, and about 10 operations a joint.
/// Exchange   with any other integrator.

#include <span>

#include "murosimf/linking/fixed_value.h"
#include "murosimf/linking/integrator.h"
#include "murosimf/modules/integration/runge_kutta_kernel.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// weight: b_i; next: a_(i+1).
struct RungeKuttaCoefficients {
  double weight = 0, next = 0;
};

class RungeKutta : public Integrator {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void initialise(const BlockMemory& block) const override;
  void adopt(const BlockMemory& one) const override { manner_.adopt(one); }
  void step(const BlockMemory& block, const StepTime& time) const override;

 protected:
  RungeKutta(std::span<const RungeKuttaCoefficients> stages, const StepManner& manner);

 private:
  std::vector<RungeKuttaStage> stages_;
  FixedValue<StepManner> manner_;
  ColumnRef initial_;
  int width_ = 1;
  KernelSet<RungeKuttaStage>::Kernel advance_ = nullptr;
};

class ExplicitEuler final : public RungeKutta {
 public:
  ExplicitEuler();
};
class Midpoint final : public RungeKutta {
 public:
  Midpoint();
};
class RungeKutta4 final : public RungeKutta {
 public:
  RungeKutta4();
};

}  // namespace murosimf
