#include "game/agent_server_program.h"

#include <mutex>

#include "murosimf/control/agent_server/agent_port.h"

namespace murosimf {

namespace {

using agent_server::AgentDesk;
using agent_server::AgentPort;
using agent_server::AgentPortSettings;

constexpr double kLongestWait = 86400;

std::vector<ProgramParameter> parameters() {
  const AgentPortSettings usual;
  return {
      {"port", static_cast<double>(usual.port), "to listen on, one for all agents; 0: any free one", 0, 65535, "",
       true},
      {"host", usual.host, "address to listen on; `0.0.0.0`: all of this machine's"},
      {"allow", usual.allowed, "hosts that agents may come from"},
      {"team", usual.team, "name that this team's agents say; empty: the left team's is the first that comes"},
      {"lock_step",
       std::string("auto"),
       "the game waits for each agent's message, `yes` or `no`; `auto`: unless simulation.pace is above 0",
       0,
       0,
       "",
       false,
       {"auto", "yes", "no"}},
      {"connect_wait", usual.connect_wait, "in lock-step, how long the start waits for the agent", 0, kLongestWait,
       "s"},
      {"patience", usual.delay.patience, "in lock-step, what a message may take at no charge", 0, kLongestWait, "s"},
      {"budget", usual.delay.budget, "in lock-step, what messages may take beyond it within 25 s", 0, kLongestWait,
       "s"},
  };
}

AgentPortSettings settingsOf(const ProgramValues& values, const client::RobotDescription& robot) {
  AgentPortSettings s;
  s.port = values.whole("port");
  s.host = values.text("host");
  s.allowed = values.texts("allow");
  s.team = values.text("team");
  const std::string& lock_step = values.text("lock_step");
  s.lock_step = lock_step == "yes" || (lock_step == "auto" && !robot.paced);
  s.connect_wait = values.number("connect_wait");
  s.delay.patience = values.number("patience"), s.delay.budget = values.number("budget");
  return s;
}

/// One desk for all robots of a game, from the first that needs it on.
class SharedDesk {
 public:
  std::shared_ptr<AgentDesk> get() {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<AgentDesk> desk = desk_.lock();
    if (desk == nullptr) desk_ = desk = std::make_shared<AgentDesk>(std::make_shared<FrameServer>());
    return desk;
  }

 private:
  std::mutex mutex_;
  std::weak_ptr<AgentDesk> desk_;
};

}  // namespace

ControlProgram agentServerProgram() {
  const auto shared = std::make_shared<SharedDesk>();
  return {parameters(), [shared](const ProgramValues& values, const client::RobotDescription& robot) {
            return std::make_unique<AgentPort>(shared->get(), settingsOf(values, robot));
          }};
}

}  // namespace murosimf
