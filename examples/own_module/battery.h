#pragma once

/// @file A battery that feeds the servos: charge falls with time and with the joints' speeds.
///
/// Model      charge' = -(P_0 + k sum |dq_j|) / C, held at 0 when empty. P_0 idle_power [W], k loss [W s/rad],
///            C battery_capacity [J].
/// Exchange   stands beside any module that adds joint_velocity.

#include "murosimf/linking/robot_module.h"

inline constexpr murosimf::Constant<double> kBatteryCapacity{"battery_capacity", "J", "C > 0, energy when full"};
inline constexpr murosimf::Variable<double> kBatteryCharge{"battery_charge", "1", "share of the capacity that is left"};
inline constexpr murosimf::Variable<double> kTimeEmpty{"battery_time_empty", "s", "time since it became empty"};

class Battery final : public murosimf::RobotModule {
 public:
  static std::vector<murosimf::ParameterInfo> parameters();
  explicit Battery(const murosimf::ParameterValues& values);
  void declare(murosimf::Declaration& declaration) const override;

 private:
  void bind(murosimf::Links& links) override;
  void initialiseRobot(const murosimf::RobotLane& robot) const override;
  void stepRobot(const murosimf::RobotLane& robot, const murosimf::StepTime& time) const override;

  double idle_power_, loss_;
  murosimf::RobotValues<const double> capacity_;
  murosimf::RobotValues<double> velocity_, charge_, time_empty_;
};

/// Scenarios may name it from then on.
inline void addBattery(murosimf::ModuleRegistry& modules) {
  modules.add<Battery>("battery", "energy", "charge falls with joint speed", Battery::parameters());
}
