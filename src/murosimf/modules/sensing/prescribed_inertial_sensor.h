#pragma once

/// @file dynamic_inertial_sensor for robots whose joints move as prescribed: asks for no more than the bodies between
/// base and units.
///
/// Model      algorithms/inertial_reading.h, with the accelerations of body_accelerations, found on the way from the
///            base to each unit's body alone.
/// Phase      kEvaluate, behind simplified_dynamics.
/// Cost       about 60 operations, and 30 a joint of the way, each for every unit.
/// Exchange   with any module that adds gyroscope and accelerometer.

#include "murosimf/linking/module.h"
#include "murosimf/modules/sensing/prescribed_inertial_sensor_kernel.h"

namespace murosimf {

class PrescribedInertialSensor final : public BlockModule {
 public:
  void declare(Declaration& declaration) const override;
  void link(Links& links) override;
  void step(const BlockMemory& block, const StepTime& time) const override { kernel_(arguments_, block, time); }

 private:
  std::vector<KernelRow> rows_;
  std::vector<std::vector<int>> ways_;  ///< of each unit
  std::vector<UnitWay> units_;
  PrescribedInertialSensorArguments arguments_;
  KernelSet<PrescribedInertialSensorArguments>::Kernel kernel_ = nullptr;
};

}  // namespace murosimf
