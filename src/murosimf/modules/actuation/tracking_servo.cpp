#include "murosimf/modules/actuation/tracking_servo.h"

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {
constexpr Variable<double> kEagerness{"servo_eagerness", "1/s", "joint velocity per error of position: 1 / lag",
                                      Storage::kKept};
constexpr double kAtOnce = 1e9;  // [1/s]
}  // namespace

std::vector<ParameterInfo> TrackingServo::parameters() {
  return {{"lag", "s", "time constant of following a command; -1: of each servo's gains, kd / kp", -1, -1, 1},
          {"largest_acceleration", "rad/s^2", "of the joints; 0: any", 100, 0, 1e6}};
}

TrackingServo::TrackingServo(const ParameterValues& values)
    : lag_(values["lag"]), largest_acceleration_(values["largest_acceleration"]) {}

void TrackingServo::declare(Declaration& d) const {
  d.runsIn(Phase::kPrescribe);
  d.needs(kLowerLimit, subset::kJoints);
  d.needs(kUpperLimit, subset::kJoints);
  d.needs(kLargestVelocity, subset::kJoints);
  d.uses(kServoStiffness, 0.0, subset::kJoints);
  d.uses(kServoDamping, 0.0, subset::kJoints);
  d.uses(kLargestAcceleration, largest_acceleration_, subset::kJoints);
  d.reads(kJointCommand, subset::kJoints);
  d.readsLast(kJointPosition, subset::kJoints);
  d.readsLast(kJointVelocity, subset::kJoints);
  d.adds(kEagerness, subset::kJoints);
  d.adds(kJointRateDemand, subset::kJoints);
}

void TrackingServo::link(Links& links) {
  TrackingServoArguments& a = arguments_;
  a.joints = links.count(subset::kJoints);
  a.command = links.column(kJointCommand, subset::kJoints);
  a.position = links.column(kJointPosition, subset::kJoints);
  a.velocity = links.column(kJointVelocity, subset::kJoints);
  a.lower = links.column(kLowerLimit, subset::kJoints);
  a.upper = links.column(kUpperLimit, subset::kJoints);
  a.largest_velocity = links.column(kLargestVelocity, subset::kJoints);
  a.demand = links.column(kJointRateDemand, subset::kJoints);
  a.eagerness = links.column(kEagerness, subset::kJoints);
  a.largest_acceleration = links.column(kLargestAcceleration, subset::kJoints);
  stiffness_ = links.column(kServoStiffness, subset::kJoints);
  damping_ = links.column(kServoDamping, subset::kJoints);
  width_ = links.width();
  kernel_ = kernelOfWidth<TrackingServoArguments>(width_);
}

void TrackingServo::initialise(const BlockMemory& block) const {
  const auto numbers = [&](ColumnRef column) {
    return block.piece[static_cast<int>(column.memory)] + column.offset * width_;
  };
  const double *kp = numbers(stiffness_), *kd = numbers(damping_);
  double* eagerness = numbers(arguments_.eagerness);
  for (int i = 0; i < arguments_.joints * width_; ++i) {
    const double lag = lag_ >= 0 ? lag_ : kp[i] > 0 ? kd[i] / kp[i] : 0;
    eagerness[i] = lag > 0 ? 1 / lag : kAtOnce;
  }
}

}  // namespace murosimf
