#pragma once

/// @file Gyroscopes and accelerometers of inertial measurement units, from how their bodies moved over the step.
///
/// Model      w = log(R_last^T R) / dt in the unit's axes;  f = R^T (dv/dt - g), v = (p - p_last)/dt at its origin,
///            dv since the step before; g = (0, 0, -9.81) m/s^2. Both are means over the step, without noise.
/// Phase      kSense, at the rate of the motion that it follows.
/// Cost       a unit one rotation logarithm, and two rotations about an axis a joint between the base and its body.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/inertial_sensor_kernel.h"

namespace murosimf {

class InertialSensor final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  std::vector<std::vector<int>> chains_;  ///< of each unit
  std::vector<UnitChain> units_;
  InertialSensorArguments arguments_;
  KernelSet<InertialSensorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
