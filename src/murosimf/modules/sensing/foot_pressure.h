#pragma once

/// @file Pressure sensors under the four corners of each sole.
///
/// Model      the normal force that the ground contact found for the corner, with the acceleration that the dynamics
///            found: the solved one. A corner that leaves the ground within a step may show a small pull.
/// Phase      kEvaluate, behind the dynamics: with several evaluations a step the last one counts.
/// Needs      soles that are the lower faces of boxes that collide (ground_contact.h).
/// Adds       sole_pressure of each sole, corners in the order (-x -y), (+x -y), (-x +y), (+x +y).
/// Cost       15 operations a corner.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/foot_pressure_kernel.h"

namespace murosimf {

class FootPressure final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<SoleCorners> soles_;
  FootPressureArguments arguments_;
  KernelSet<FootPressureArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
