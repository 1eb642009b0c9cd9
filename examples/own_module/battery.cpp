#include "battery.h"

#include "murosimf/world/vocabulary.h"

using namespace murosimf;

std::vector<ParameterInfo> Battery::parameters() {
  return {{"idle_power", "W", "taken by the electronics", 3.0, 0.0, 100.0},
          {"loss", "W s/rad", "taken per joint speed", 1.0, 0.0, 100.0}};
}

Battery::Battery(const ParameterValues& values) : idle_power_(values["idle_power"]), loss_(values["loss"]) {}

void Battery::declare(Declaration& d) const {
  d.runsIn(Phase::kSense);  // when the joints have moved
  d.needs(kBatteryCapacity);
  d.reads(kJointVelocity, subset::kJoints);
  d.adds(kBatteryCharge);
  d.adds(kTimeEmpty);
}

void Battery::bind(Links& links) {
  capacity_ = links.values(kBatteryCapacity);
  velocity_ = links.values(kJointVelocity, subset::kJoints);
  charge_ = links.values(kBatteryCharge);
  time_empty_ = links.values(kTimeEmpty);
}

void Battery::initialiseRobot(const RobotLane& robot) const { robot.set(charge_, 1.0); }

void Battery::stepRobot(const RobotLane& robot, const StepTime& time) const {
  double power = idle_power_;
  for (int j = 0; j < velocity_.objects; ++j) power += loss_ * abs(robot.get(velocity_, j));
  const double charge = max(robot.get(charge_) - power * time.dt / robot.get(capacity_), 0.0);
  robot.set(charge_, charge);
  if (charge == 0) robot.set(time_empty_, robot.get(time_empty_) + time.dt);
}
