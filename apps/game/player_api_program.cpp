#include "game/player_api_program.h"

#include <mutex>

#include "murosimf/control/player_api/player_port.h"

namespace murosimf {

namespace {

using player_api::PlayerPort;
using player_api::PlayerPortSettings;

constexpr double kMostMegabytes = 1e6, kLongestWait = 86400;

std::vector<ProgramParameter> parameters() {
  const PlayerPortSettings usual;
  return {
      {"port", -1.0, "to listen on; -1: 10000 + the number of a red robot, 10020 + of a blue one; 0: any free one", -1,
       65535, "", true},
      {"host", usual.host, "address to listen on; `0.0.0.0`: all of this machine's"},
      {"allow", usual.allowed, "hosts that clients may come from"},
      {"lock_step",
       std::string("auto"),
       "the game waits for each client's answer, `yes` or `no`; `auto`: unless simulation.pace is above 0",
       0,
       0,
       "",
       false,
       {"auto", "yes", "no"}},
      {"connect_wait", usual.connect_wait, "in lock-step, how long the start waits for the client", 0, kLongestWait,
       "s"},
      {"patience", usual.delay.patience, "in lock-step, what an answer may take at no charge", 0, kLongestWait, "s"},
      {"budget", usual.delay.budget, "in lock-step, what answers may take beyond it within 25 s", 0, kLongestWait, "s"},
      {"rendering_quota", usual.rendering_quota, "of a robot's pictures, in simulated time", 0, kMostMegabytes,
       "MiB/s"},
      {"network_quota", usual.network_quota, "of what is sent to a client, in simulated time unless the game is paced",
       0, kMostMegabytes, "MiB/s"},
  };
}

PlayerPortSettings settingsOf(const ProgramValues& values, const client::RobotDescription& robot) {
  PlayerPortSettings s;
  s.port = values.whole("port") >= 0 ? values.whole("port") : player_api::usualPort(robot);
  s.host = values.text("host");
  s.allowed = values.texts("allow");
  const std::string& lock_step = values.text("lock_step");
  s.lock_step = lock_step == "yes" || (lock_step == "auto" && !robot.paced);
  s.connect_wait = values.number("connect_wait");
  s.delay.patience = values.number("patience"), s.delay.budget = values.number("budget");
  s.rendering_quota = values.number("rendering_quota"), s.network_quota = values.number("network_quota");
  return s;
}

/// One server for all robots of a game, from the first that needs it on.
class SharedServer {
 public:
  std::shared_ptr<FrameServer> get() {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<FrameServer> server = server_.lock();
    if (server == nullptr) server_ = server = std::make_shared<FrameServer>();
    return server;
  }

 private:
  std::mutex mutex_;
  std::weak_ptr<FrameServer> server_;
};

}  // namespace

ControlProgram playerApiProgram() {
  const auto shared = std::make_shared<SharedServer>();
  return {parameters(), [shared](const ProgramValues& values, const client::RobotDescription& robot) {
            return std::make_unique<PlayerPort>(shared->get(), settingsOf(values, robot));
          }};
}

}  // namespace murosimf
