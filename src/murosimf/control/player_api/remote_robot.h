#pragma once

/// @file The client's side: runs control software against a robot behind a player API, in step with its messages.
///
/// Each message of measurements is one step; what it commands is the answer. Everything that the robot has is turned
/// on with the first requests, cameras with the periods of `periods` or their own. It asks for our own fields, which
/// carry what the original API leaves to other ways (docs/player_api.md), so that the program runs as if linked in.

#include <functional>
#include <memory>
#include <string>

#include "murosimf/control/client/control_software.h"

namespace murosimf::player_api {

struct RemoteRobotSettings {
  std::string host = "127.0.0.1";
  int port = 10001;
  double patience = 20;  ///< how long to try to connect [s]
  bool pictures = true;  ///< whether cameras are turned on
};

/// What has been done.
struct RemoteRun {
  long steps = 0;
  std::string team;
  int number = 0;
  double seconds = 0;  ///< simulated, from the first message to the last [s]
  long warnings = 0;
};

/// Runs until the server closes the connection. @param warn  gets every message of the server
/// @throws std::system_error, std::runtime_error where nobody listens, where it refuses us, or speaks something else
RemoteRun runRemotely(client::ControlSoftware& program, const RemoteRobotSettings& settings,
                      const std::function<void(const std::string&)>& warn);

}  // namespace murosimf::player_api
