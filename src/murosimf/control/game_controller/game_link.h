#pragma once

/// @file Sends a game controller's packets and hears what robots say of themselves, on a thread of its own.
///
/// Whoever hands over packets never waits: of those that have not left, the oldest are dropped. Robots are kept by team
/// and player, the last word of each.

#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "murosimf/control/game_controller/packets.h"
#include "murosimf/control/wire/tcp_socket.h"
#include "murosimf/control/wire/udp_socket.h"

namespace murosimf::game_controller {

struct GameLinkSettings {
  std::string host = "127.0.0.1";         ///< that packets go to; a network's last address: to all of it
  int port = 3838;                        ///< that they go to
  std::string listen_host = "127.0.0.1";  ///< address on which robots are heard
  int return_port = 3939;                 ///< on which robots are heard; 0: any free one
  bool broadcast = false;
  std::vector<std::string> allowed = {"127.0.0.1"};  ///< hosts whose robots are heard
};

/// What has been heard of a robot.
struct HeardRobot {
  RobotStatus status;  ///< the last; of the old format player and team alone
  long packets = 0;
};

struct GameLinkCounts {
  long sent = 0, dropped = 0, heard = 0, refused = 0, strangers = 0;
  std::string last_problem;  ///< of a packet that was refused
};

class GameLink {
 public:
  /// @throws std::system_error, std::invalid_argument as openUdp() and udpAddress() do
  explicit GameLink(const GameLinkSettings& settings);
  ~GameLink();
  GameLink(const GameLink&) = delete;
  GameLink& operator=(const GameLink&) = delete;

  /// Leaves within some milliseconds. Makes no system call.
  void send(Bytes&& packet);
  /// By team number and player.
  std::map<std::pair<int, int>, HeardRobot> robots() const;
  GameLinkCounts counts() const;
  /// On which robots are heard.
  int returnPort() const { return return_port_; }

 private:
  void serve();
  void sendAll();
  void hearAll();
  void hear(std::span<const std::uint8_t> bytes);
  void wake() const;

  UdpAddress to_;
  HostList allowed_;
  FileDescriptor socket_, wake_;
  int return_port_ = 0;
  mutable std::mutex mutex_;  // of what follows; never held in a system call
  std::deque<Bytes> to_send_;
  std::map<std::pair<int, int>, HeardRobot> robots_;
  GameLinkCounts counts_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace murosimf::game_controller
