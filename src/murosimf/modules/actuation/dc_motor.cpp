#include "murosimf/modules/actuation/dc_motor.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/linking/links.h"
#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr Variable<double> kVelocityLast{"gear_friction_velocity", "rad/s", "dq when friction was last asked for"};

const GearFriction<const Constant<double>*> kGear{
    &kFrictionBase,          &kFrictionStribeck,          &kLoadFrictionMotor,
    &kLoadFrictionExternal,  &kLoadFrictionMotorStribeck, &kLoadFrictionExternalStribeck,
    &kLoadFrictionMotorQuad, &kLoadFrictionExternalQuad,  &kFrictionSpeed,
    &kFrictionExponent};

}  // namespace

std::vector<ParameterInfo> DcMotor::parameters() {
  return {{"friction_model", "1", "leaves out what the model M1 to M6 of the gear's friction does not have", 6, 1, 6},
          {"stick_speed", "rad/s", "below which dry friction is viscous", 1e-3, 1e-9, 1}};
}

DcMotor::DcMotor(const ParameterValues& values) {
  const double model = values["friction_model"];
  if (model != static_cast<int>(model)) {
    throw std::invalid_argument(fmt::format("friction_model is {}; expected a whole number from 1 to 6", model));
  }
  arguments_.load = model >= 3 ? 1 : 0;
  arguments_.stribeck = model >= 2 && model != 3 ? 1 : 0;
  arguments_.quadratic = model >= 6 ? 1 : 0;
  arguments_.stick_speed = values["stick_speed"];
}

void DcMotor::declare(Declaration& d) const {
  d.runsIn(Phase::kEvaluate);
  for (const auto* constant : {&kTorqueConstant, &kMotorResistance, &kSupplyVoltage, &kFirmwareGain, &kErrorGain}) {
    d.needs(*constant, subset::kJoints);
  }
  d.uses(kLargestDuty, kDefaultDuty, subset::kJoints);
  d.uses(kLargestCurrent, kNoCurrentLimit, subset::kJoints);
  d.uses(kBacklash, 0.0, subset::kJoints);
  d.uses(kFrictionViscous, 0.0, subset::kJoints);
  kGear.mapped([&](const Constant<double>* constant) {
    const bool speed = constant == &kFrictionSpeed, exponent = constant == &kFrictionExponent;
    d.uses(*constant, speed ? kDefaultFrictionSpeed : exponent ? kDefaultFrictionExponent : 0.0, subset::kJoints);
    return 0;
  });
  d.reads(kServoDemand, subset::kJoints);
  d.reads(kJointPosition, subset::kJoints);
  d.reads(kJointVelocity, subset::kJoints);
  d.readsLast(kGearLoad, subset::kJoints);
  d.accumulates(kJointTorque, subset::kJoints);
  d.accumulates(kJointInertia, subset::kJoints);
  d.adds(kVelocityLast, subset::kJoints);
  d.adds(kMotorTorque, subset::kJoints);
  d.adds(kMotorInertia, subset::kJoints);
}

void DcMotor::link(Links& links) {
  DcMotorArguments& a = arguments_;
  const auto column = [&](const auto& property) { return links.column(property, subset::kJoints); };
  a.joints = links.count(subset::kJoints);
  a.demand = column(kServoDemand);
  a.position = column(kJointPosition), a.velocity = column(kJointVelocity), a.velocity_last = column(kVelocityLast);
  a.gear_load = column(kGearLoad);
  a.torque_constant = column(kTorqueConstant), a.resistance = column(kMotorResistance);
  a.supply = column(kSupplyVoltage);
  a.firmware_gain = column(kFirmwareGain), a.error_gain = column(kErrorGain);
  a.largest_duty = column(kLargestDuty), a.largest_current = column(kLargestCurrent);
  a.backlash = column(kBacklash), a.viscous = column(kFrictionViscous);
  a.friction = kGear.mapped([&](const Constant<double>* constant) { return column(*constant); });
  a.torque = column(kJointTorque), a.inertia = column(kJointInertia);
  a.motor_torque = column(kMotorTorque), a.motor_inertia = column(kMotorInertia);
  kernel_ = kernelOfWidth<DcMotorArguments>(links.width());
}

}  // namespace murosimf
