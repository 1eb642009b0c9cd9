#include "murosimf/control/servo_bus/servo_units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace murosimf::servo_bus {

namespace {

constexpr double kFigureVoltage = 12;       // [V] at which the tables give torque and speed
constexpr double kOldShare = 0.158;         // of the voltage, per radian and P
constexpr double kOldDerivative = 0.032;    // [s], of D against P
constexpr double kControllerPeriod = 1e-3;  // [s]
constexpr double kStepsPerRadian = kStepsPerTurn / (2 * std::numbers::pi);
constexpr double kProfileUnit = 214.577 * 2 * std::numbers::pi / 3600;  // [rad/s^2] of 214.577 rev/min^2
constexpr double kOldProfileUnit = 8.583 * std::numbers::pi / 180;      // [rad/s^2]
constexpr std::int64_t kSignBit = 1024;

}  // namespace

ServoScale scaleOf(const ControlTable& table, double supply_voltage) {
  const ServoFigures& f = table.figures;
  const double share = supply_voltage / kFigureVoltage;
  return {f.stall_torque * share, f.no_load_speed * share, f.stall_torque / f.stall_current,
          f.velocity_unit,        f.current_unit,          table.old};
}

double angleOf(double steps) { return steps / kStepsPerRadian; }
std::int64_t stepsOf(double angle) { return std::llround(angle * kStepsPerRadian); }

double stiffnessOf(const ServoScale& scale, double p_gain) {
  const double share = scale.old ? kOldShare * p_gain : p_gain / 128 * kStepsPerRadian / kLargestPwm;
  return scale.stall_torque * share;
}

double dampingOf(const ServoScale& scale, double d_gain) {
  const double share =
      scale.old ? kOldShare * kOldDerivative * d_gain : d_gain / 16 * kStepsPerRadian * kControllerPeriod / kLargestPwm;
  return scale.stall_torque * share;
}

double inducedDamping(const ServoScale& scale) { return scale.stall_torque / scale.no_load_speed; }

std::int64_t withSignBit(double value) {
  const std::int64_t size = std::min<std::int64_t>(std::llround(std::abs(value)), kSignBit - 1);
  return value < 0 && size > 0 ? size | kSignBit : size;
}

double fromSignBit(std::int64_t value) {
  const auto size = static_cast<double>(value & (kSignBit - 1));
  return (value & kSignBit) != 0 ? -size : size;
}

std::int64_t velocityRegister(const ServoScale& scale, double velocity) {
  const double units = velocity / scale.velocity_unit;
  return scale.old ? withSignBit(units) : std::llround(units);
}

double accelerationOf(const ServoScale& scale, std::int64_t value) {
  return static_cast<double>(value) * (scale.old ? kOldProfileUnit : kProfileUnit);
}

}  // namespace murosimf::servo_bus
