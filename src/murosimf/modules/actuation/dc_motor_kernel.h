#pragma once

/// @file Kernel of dc_motor.h.

#include "murosimf/algorithms/gear_friction.h"
#include "murosimf/linking/kernel.h"
#include "murosimf/modules/actuation/command_lanes.h"
#include "murosimf/modules/actuation/gear_play.h"

namespace murosimf {

struct DcMotorArguments {
  int joints = 0;
  double stick_speed = 0;                        ///< [rad/s]
  double load = 1, stribeck = 1, quadratic = 1;  ///< 0: the friction model leaves these terms out
  ColumnRef demand, position, velocity, velocity_last, gear_load;
  ColumnRef torque_constant, resistance, supply, firmware_gain, error_gain, largest_duty, largest_current;
  ColumnRef backlash, viscous;
  GearFriction<ColumnRef> friction;
  ColumnRef torque, inertia, motor_torque, motor_inertia;
};

void addBaselineKernels(KernelSet<DcMotorArguments>& kernels);
void addWideKernels(KernelSet<DcMotorArguments>& kernels);

inline namespace MUROSIMF_ISA {

/// One motor with its controller.
template <class S>
struct MotorLanes {
  S torque_constant, resistance, supply, gain, largest_duty, largest_current;  ///< gain: duty per error [1/rad]
  S backlash;                                                                  ///< [rad]
};

/// tau of a motor, and what of it depends on the joint's acceleration; loose: the joint is within the gear's play.
template <class S>
struct MotorTorque {
  S torque, inertia;
  decltype(S(0) < S(0)) loose;
};

template <class S>
inline MotorTorque<S> motorTorque(const MotorLanes<S>& m, const CommandLanes<S>& demand, S q, S dq, S h) {
  const S slope = m.torque_constant / m.resistance;                      // torque per volt
  const S back = m.torque_constant * dq, stiffness = m.supply * m.gain;  // [V], [V/rad]
  const auto on = demand.kp > S(0);
  const auto plays = on & (m.backlash > S(0));
  const S asked = demand.torque / slope;
  S error = demand.position - fma(h, dq, q);  // as it will be if the joint goes on like this
  S wanted = select(on, stiffness * error, back) + asked;
  if (any(plays)) {
    error = beyondPlay(error + asked / stiffness, m.backlash);
    wanted = select(plays, stiffness * error, wanted);
  }
  const S span = m.resistance * m.largest_current, most = m.supply * m.largest_duty;
  const S allowed = clamp(wanted, back - span, back + span);
  const S given = clamp(allowed, -most, most);
  const auto at_voltage = (given < allowed) | (given > allowed);
  const auto at_current = (allowed < wanted) | (allowed > wanted);
  const S controlled = select(on & !at_current, fma(h, stiffness, m.torque_constant), S(0));
  MotorTorque<S> result;
  result.torque = slope * (given - back);
  result.inertia = h * slope * select(at_voltage, m.torque_constant, controlled);
  result.loose = plays & isLoose(error, result.torque);
  return result;
}

template <class S>
inline MotorLanes<S> motorAt(const DcMotorArguments& a, const BlockMemory& block, int j) {
  const auto at = [&](ColumnRef column) { return columnAt<S, S>(block, column)[j]; };
  return {at(a.torque_constant), at(a.resistance),      at(a.supply),  at(a.error_gain) * at(a.firmware_gain),
          at(a.largest_duty),    at(a.largest_current), at(a.backlash)};
}

/// The gear's parameters, without the terms that the friction model leaves out.
template <class S>
inline GearFriction<S> gearAt(const DcMotorArguments& a, const BlockMemory& block, int j) {
  GearFriction<S> g = a.friction.mapped([&](ColumnRef column) { return columnAt<S, S>(block, column)[j]; });
  const S load(a.load), stribeck(a.stribeck), both(a.load * a.stribeck), quadratic(a.quadratic);
  g.stribeck = g.stribeck * stribeck;
  g.motor_load = g.motor_load * load, g.external_load = g.external_load * load;
  g.motor_stribeck = g.motor_stribeck * both, g.external_stribeck = g.external_stribeck * both;
  g.motor_quadratic = g.motor_quadratic * quadratic, g.external_quadratic = g.external_quadratic * quadratic;
  return g;
}

template <class S>
void dcMotor(const DcMotorArguments& a, const BlockMemory& block, const StepTime& time) {
  const auto* demand = columnAt<CommandLanes<S>, S>(block, a.demand);
  const S *q = columnAt<S, S>(block, a.position), *dq = columnAt<S, S>(block, a.velocity);
  S* dq_last = columnAt<S, S>(block, a.velocity_last);
  const S *load = columnAt<S, S>(block, a.gear_load), *viscous = columnAt<S, S>(block, a.viscous);
  S *torque = columnAt<S, S>(block, a.torque), *inertia = columnAt<S, S>(block, a.inertia);
  S *own_torque = columnAt<S, S>(block, a.motor_torque), *own_inertia = columnAt<S, S>(block, a.motor_inertia);
  const S h(time.implicit), stick_speed(a.stick_speed), zero(0);
  for (int j = 0; j < a.joints; ++j) {
    const MotorTorque<S> motor = motorTorque(motorAt<S>(a, block, j), demand[j], q[j], dq[j], h);
    const S f = gearFriction(gearAt<S>(a, block, j), motor.torque, load[j], dq[j]);
    const ImplicitTorque<S> dry = dryFriction(f, dq[j], dq_last[j], stick_speed, time.implicit);
    dq_last[j] = dq[j];
    own_torque[j] = select(motor.loose, zero, fnma(viscous[j], dq[j], motor.torque + dry.torque));
    own_inertia[j] = select(motor.loose, zero, fma(h, viscous[j], motor.inertia + dry.inertia));
    torque[j] += own_torque[j];
    inertia[j] += own_inertia[j];
  }
}

}  // namespace MUROSIMF_ISA
}  // namespace murosimf
