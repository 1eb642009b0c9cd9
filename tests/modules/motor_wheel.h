#pragma once

/// @file A wheel that a direct-current motor drives.

#include <initializer_list>
#include <string>
#include <utility>

#include "modules/driven_wheel.h"
#include "murosimf/modules/actuation/motor_properties.h"

namespace murosimf::motion {

// A motor of the size of a large servo's.
inline constexpr double kK = 2.2, kR = 3, kRotor = 0.026;          // [N m/A, Ohm, kg m^2]
inline constexpr double kSupply = 15, kDuty = 0.9625, kGain = 5;   // [V, 1, 1/rad]
inline constexpr double kStallTorque = kK * kSupply * kDuty / kR;  // [N m]
inline constexpr double kNoLoadSpeed = kSupply * kDuty / kK;       // [rad/s]
inline const ServoParameters kServo{"test", kStallTorque, kNoLoadSpeed, 1, 0, kRotor, 0};

using Numbers = std::vector<std::pair<const Constant<double>*, double>>;

/// Gives wheel i the motor, without friction; `own` goes before it.
inline void motorise(Wheels& w, std::size_t i, const Numbers& own = {}) {
  const ObjectId joint = w.joint(i);
  w.world().set(joint, kTorqueConstant, kK);
  w.world().set(joint, kMotorResistance, kR);
  w.world().set(joint, kSupplyVoltage, kSupply);
  w.world().set(joint, kFirmwareGain, 1.0);
  w.world().set(joint, kErrorGain, kGain);
  w.world().set(joint, kLargestDuty, kDuty);
  for (const auto& [property, value] : own) w.world().set(joint, *property, value);
}

class MotorWheel : public Wheels {
 public:
  MotorWheel(const std::string& integrator, double step, WheelData data, const Numbers& own = {}, double push = 0,
             const WrittenParameters& parameters = {})
      : Wheels({withServo(std::move(data))}, step) {
    motorise(*this, 0, own);
    link(
        integrator,
        {{"servo_controller", {}}, {"dc_motor", parameters}, {"gear_load", {}}, {"push", {{"torque", written(push)}}}});
  }

 private:
  static WheelData withServo(WheelData data) {
    data.servo = kServo;
    return data;
  }
};

}  // namespace murosimf::motion
