#include "murosimf/modules/sensing/push_sensor.h"

#include "murosimf/world/vocabulary.h"

namespace murosimf {

void PushSensor::declare(Declaration& d) const {
  d.runsIn(Phase::kSense);
  d.needs(kTouchThreshold, subset::kTouchSensors);
  d.reads(kPushForce, subset::kTouchSensors);
  d.adds(kTouchForce, subset::kTouchSensors);
  d.adds(kTouch, subset::kTouchSensors);
}

void PushSensor::bind(Links& links) {
  threshold_ = links.values(kTouchThreshold, subset::kTouchSensors);
  push_ = links.values(kPushForce, subset::kTouchSensors);
  force_ = links.values(kTouchForce, subset::kTouchSensors);
  touch_ = links.values(kTouch, subset::kTouchSensors);
}

void PushSensor::stepRobot(const RobotLane& robot, const StepTime&) const {
  for (int i = 0; i < touch_.objects; ++i) {
    const double force = robot.get(push_, i);
    robot.set(force_, force, i);
    robot.set(touch_, force > robot.get(threshold_, i) ? 1.0 : 0.0, i);
  }
}

}  // namespace murosimf
