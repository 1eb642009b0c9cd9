#pragma once

/// @file Gyroscopes and accelerometers of inertial measurement units, from the accelerations that dynamics finds.
///
/// Model      algorithms/inertial_reading.h, without noise.
/// Phase      kEvaluate, behind the dynamics: with several evaluations a step the last one counts.
/// Cost       three cross products and two rotations a unit. No world poses are needed.
/// Exchange   with any module that adds gyroscope and accelerometer.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/dynamic_inertial_sensor_kernel.h"

namespace murosimf {

class DynamicInertialSensor final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<UnitPlace> units_;
  DynamicInertialSensorArguments arguments_;
  KernelSet<DynamicInertialSensorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
