#pragma once

/// @file A robot whose agent speaks with it as with RCSSServerMJ of the 3D Simulation League: S-expressions behind a
/// length of four bytes, one message a cycle each way. docs/agent_server.md tells all of it.
///
/// In a step, in this order:
///   free running  all messages that have come are obeyed, the newest last; perceptions are sent
///   lock-step     perceptions are sent; one message is waited for (DelayBudget) and obeyed
/// What a motor was asked for holds until it is asked for something else. A word, a motor or a number that is not
/// understood is counted and left alone, as there.

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "murosimf/control/agent_server/agent_desk.h"
#include "murosimf/control/agent_server/perceptions.h"
#include "murosimf/control/client/control_software.h"
#include "murosimf/control/wire/delay_budget.h"
#include "murosimf/control/wire/s_expression.h"

namespace murosimf::agent_server {

struct AgentPortSettings {
  std::string host = "127.0.0.1";                    ///< address to listen on
  int port = 60000;                                  ///< 0: any free one
  std::vector<std::string> allowed = {"127.0.0.1"};  ///< hosts that agents may come from
  std::string team;                                  ///< name of the robot's team; empty: who comes first
  bool lock_step = false;
  double connect_wait = 60;  ///< lock-step: how long the start waits for the agent [s]
  DelayLimits delay{5, 5};   ///< lock-step: how long steps do
};

class AgentPort final : public client::ControlSoftware {
 public:
  AgentPort(std::shared_ptr<AgentDesk> desk, const AgentPortSettings& settings);

  /// @throws client::CannotStart where it cannot listen, or the robot's number is taken
  void start(const client::RobotDescription& robot) override;
  /// In lock-step waits for the agent.
  void startCameras(std::span<double> periods) override;
  bool waitsForOthers() const override { return true; }
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override;
  std::string address() const override;
  std::vector<std::pair<std::string, double>> figures() const override;
  const client::ControlReport& report() const override { return report_; }
  /// Motors and the game's clock. The agent is not part of it: it must connect anew.
  void archive(client::StateArchive& archive) override;

 private:
  void takeSeat();
  void holdPosture(const client::SensorFrame& sensors);
  void obey(const FrameBytes& message);
  void obeyBeam(const SExpression& beam);
  void sendPerceptions(const client::SensorFrame& sensors);
  void awaitActions();

  std::shared_ptr<AgentDesk> desk_;
  AgentPortSettings settings_;
  client::RobotDescription robot_;
  Side side_ = Side::kLeft;
  int seat_ = -1;
  std::shared_ptr<FrameChannel> channel_;  // null: nobody sits there
  PerceptionWriter writer_;
  std::unordered_map<std::string, std::size_t> motors_;  // to joints
  std::vector<client::JointCommand> targets_;            // empty before the first step
  std::optional<PlanarPose> beam_;                       // in the team's own frame
  double played_ = 0;                                    // [s]
  DelayBudget budget_;
  long sent_ = 0, received_ = 0, not_understood_ = 0;
  client::ControlReport report_;
};

}  // namespace murosimf::agent_server
