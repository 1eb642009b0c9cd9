// murosimf-control: runs control software in a process of its own, against a robot behind the player API.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "all_controllers.h"
#include "murosimf/control/player_api/remote_robot.h"

namespace {

using murosimf::player_api::RemoteRobotSettings;
using murosimf::player_api::RemoteRun;

std::vector<std::string> programNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : murosimf::controllers::allControllers()) names.push_back(name);
  return names;
}

/// HOST:PORT, HOST or PORT.
void readAddress(const std::string& address, RemoteRobotSettings& settings) {
  const std::size_t colon = address.rfind(':');
  const std::string port = colon == address.npos ? address : address.substr(colon + 1);
  if (colon != address.npos) settings.host = address.substr(0, colon);
  std::size_t used = 0;
  try {
    settings.port = std::stoi(port, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != port.size() || port.empty() || settings.port < 1 || settings.port > 65535)
    throw CLI::ValidationError(
        "address", fmt::format("\"{}\" is no address, expected HOST:PORT or a port from 1 to 65535", address));
}

void play(const std::string& program, const RemoteRobotSettings& settings) {
  const auto controller = murosimf::controllers::allControllers().at(program)();
  const RemoteRun run = murosimf::player_api::runRemotely(
      *controller, settings, [](const std::string& text) { fmt::print(stderr, "server: {}\n", text); });
  fmt::print("{} {}: {} steps, {:.3f} s of the game, {} messages of the server\n", run.team, run.number, run.steps,
             run.seconds, run.warnings);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs control software against a robot behind the player API (docs/player_api.md)", "murosimf-control");
  std::string program = "player", address = "127.0.0.1:10001";
  RemoteRobotSettings settings;
  app.add_option("program", program, "control software")->check(CLI::IsMember(programNames()))->capture_default_str();
  app.add_option("address", address, "HOST:PORT of the robot, or its port")
      ->envname("ROBOCUP_SIMULATOR_ADDR")
      ->capture_default_str();
  app.add_option("--patience", settings.patience, "seconds to try to connect")->capture_default_str();
  app.add_flag("!--no-pictures", settings.pictures, "leave cameras off");
  try {
    app.parse(argc, argv);
    readAddress(address, settings);
    play(program, settings);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? 0 : 2;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "murosimf-control: {}\n", problem.what());
    return 1;
  }
  return 0;
}
