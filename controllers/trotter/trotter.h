#pragma once

/// @file Control software of the four-legged robot rappe: it trots as its role says (trot_plan.h).
///
/// Each control period: attitude from the inertial sensor, the order that holds, joint angles of the trot. Each command
/// has the speed that takes the joint there within the period: without it servos would move in starts and stops, which
/// shakes the robot and lets the gyroscope, read once a period, miss part of its turning. A robot that lies on its side
/// or back gives up and holds its legs still.

#include <memory>

#include "murosimf/control/client/control_software.h"
#include "trot_engine.h"
#include "trot_plan.h"

namespace murosimf::controllers::trotter {

class Trotter final : public client::ControlSoftware {
 public:
  /// @throws std::invalid_argument for a robot that is no rappe, and for a role that is no plan
  void start(const client::RobotDescription& robot) override;
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override;
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive& archive) override;

 private:
  void command(const JointAngles& angles, client::CommandFrame& commands);

  double period_ = 0.01;  ///< of control [s]
  std::vector<TrotOrder> plan_;
  TrotEngine engine_;
  JointAngles commanded_{};
  client::ControlReport report_;
};

std::unique_ptr<client::ControlSoftware> makeTrotter();

}  // namespace murosimf::controllers::trotter
