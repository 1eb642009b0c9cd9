#include "trotter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace murosimf::controllers::trotter {

namespace {

constexpr double kServoStiffness = 160, kServoDamping = 1.3;  // [N m/rad], [N m s/rad]
constexpr double kLeastSpeed = 0.05;                          // [rad/s]: 0 would be no limit at all
constexpr double kLyingUpright = 0.5;                         // cosine of the tilt at which a trunk lies

void requireRappe(const client::RobotDescription& robot) {
  if (robot.joints.size() != kJointCount)
    throw std::invalid_argument("trotter: a rappe with 12 joints is expected, '" + robot.model + "' has " +
                                std::to_string(robot.joints.size()));
  for (std::size_t i = 0; i < kJointCount; ++i) {
    if (robot.joints[i].name != kJointNames[i])
      throw std::invalid_argument("trotter: joint " + std::to_string(i) + " of '" + robot.model + "' is '" +
                                  robot.joints[i].name + "', expected '" + std::string(kJointNames[i]) + "'");
  }
}

}  // namespace

void Trotter::start(const client::RobotDescription& robot) {
  requireRappe(robot);
  period_ = robot.control_period;
  plan_ = readTrotPlan(robot.role);
  commanded_ = trotPose(engine_.parameters, 0, 0, {}, {});
}

void Trotter::step(const client::SensorFrame& sensors, client::CommandFrame& commands) {
  const bool lies = engine_.attitude().upright() < kLyingUpright;
  const TrotCommand wanted = lies ? TrotCommand{} : orderAt(plan_, sensors.time);
  wanted == TrotCommand{} ? engine_.stop() : engine_.trot(wanted);
  command(engine_.step(period_, {sensors.angular_velocity, sensors.specific_force}), commands);
  report_.activity = lies ? "lie" : engine_.standing() ? "stand" : "trot";
}

void Trotter::command(const JointAngles& angles, client::CommandFrame& commands) {
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const double speed = std::fabs(angles[i] - commanded_[i]) / period_;
    commands.joints[i] = {angles[i], std::max(speed, kLeastSpeed), 0, kServoStiffness, kServoDamping};
  }
  commanded_ = angles;
}

void Trotter::archive(client::StateArchive& archive) { archive(engine_, commanded_); }

std::unique_ptr<client::ControlSoftware> makeTrotter() { return std::make_unique<Trotter>(); }

}  // namespace murosimf::controllers::trotter
