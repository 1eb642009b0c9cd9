#include "murosimf/modules/actuation/servo_controller.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

struct CommandRing {
  ServoCommand places[kCommandPlaces];
};

constexpr Variable<double> kHeldPosition{"held_position", "rad", "that the servo's electronics hold"};
constexpr Variable<CommandRing> kCommandsOnTheWay{"commands_on_the_way", "SI", "of the last steps"};

int wholeNumber(const ParameterValues& values, const char* name) {
  const double value = values[name];
  if (value == static_cast<int>(value)) return static_cast<int>(value);
  throw std::invalid_argument(fmt::format("{} is {}; expected a whole number", name, value));
}

}  // namespace

std::vector<ParameterInfo> ServoController::parameters() {
  return {{"commanded_gains", "1", "1: kp, kd and velocity of the command hold; 0: the servo's own gains", 0, 0, 1},
          {"encoder_steps", "1", "1: the servo knows its position in steps of encoder_resolution", 0, 0, 1},
          {"delay_steps", "1", "steps of the module after which commands act", 0, 0, kCommandPlaces - 1}};
}

ServoController::ServoController(const ParameterValues& values) {
  arguments_.commanded_gains = wholeNumber(values, "commanded_gains") == 1;
  arguments_.encoder_steps = wholeNumber(values, "encoder_steps") == 1;
  arguments_.delay_steps = wholeNumber(values, "delay_steps");
}

void ServoController::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kLowerLimit, subset::kJoints);
  d.needs(kUpperLimit, subset::kJoints);
  d.needs(kServoStiffness, subset::kJoints);
  d.needs(kServoDamping, subset::kJoints);
  d.uses(kEncoderResolution, 0.0, subset::kJoints);
  d.reads(kJointCommand, subset::kJoints);
  d.readsLast(kJointPosition, subset::kJoints);
  d.adds(kServoDemand, subset::kJoints);
  d.adds(kHeldPosition, subset::kJoints);
  if (arguments_.delay_steps > 0) d.adds(kCommandsOnTheWay, subset::kJoints);
}

void ServoController::link(Links& links) {
  ServoControllerArguments& a = arguments_;
  a.joints = links.count(subset::kJoints);
  a.command = links.column(kJointCommand, subset::kJoints);
  a.position = links.column(kJointPosition, subset::kJoints);
  a.lower = links.column(kLowerLimit, subset::kJoints);
  a.upper = links.column(kUpperLimit, subset::kJoints);
  a.kp = links.column(kServoStiffness, subset::kJoints);
  a.kd = links.column(kServoDamping, subset::kJoints);
  a.resolution = links.column(kEncoderResolution, subset::kJoints);
  a.held = links.column(kHeldPosition, subset::kJoints);
  a.demand = links.column(kServoDemand, subset::kJoints);
  if (a.delay_steps > 0) a.on_the_way = links.column(kCommandsOnTheWay, subset::kJoints);
  kernel_ = kernelOfWidth<ServoControllerArguments>(links.width());
}

}  // namespace murosimf
