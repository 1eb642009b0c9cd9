#pragma once

/// @file The one port that all agents of a game connect to: reads who each wants to be, and leads it to its robot.
///
/// A robot has a seat: a side, a jersey number and a model. An agent's first message names a model, a team and a
/// number; it gets the seat of that number on its team's side, or the first free one for the number 0. The first team
/// that comes plays on the left, the next one on the right, unless the scenario names the sides' teams.
/// An agent that asks for what is not there is told why, as `(error "why")`, and disconnected.

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control/wire/frame_server.h"

namespace murosimf::agent_server {

enum class Side : std::uint8_t { kLeft, kRight };

struct Seat {
  Side side = Side::kLeft;
  int number = 0;
  std::string model;  ///< as robot files name it; agents may write it in capitals
  std::string team;   ///< whose agents sit on this side; empty: the next team's that comes
};

/// What an agent says first: (init MODEL TEAM NUMBER).
struct AgentRequest {
  std::string model, team;
  int number = 0;
};

/// @param problem  gets what is wrong where nothing is returned
std::optional<AgentRequest> readAgentRequest(std::string_view message, std::string& problem);

class AgentDesk {
 public:
  explicit AgentDesk(std::shared_ptr<FrameServer> server);
  ~AgentDesk();
  AgentDesk(const AgentDesk&) = delete;
  AgentDesk& operator=(const AgentDesk&) = delete;

  /// @returns its index. @throws std::invalid_argument where side and number are taken already, or where the side's
  /// team is called otherwise
  int addSeat(const Seat& seat);
  /// Listens, unless it does already. @throws as FrameServer::listen(); std::invalid_argument where it listens
  /// elsewhere
  void listen(const FramePort& port);
  /// Leads agents that have said who they are to their seats. Any program's thread; does not wait.
  void attend();
  /// The agent on this seat; null: nobody sits there. Changes with attend() alone.
  std::shared_ptr<FrameChannel> channelOf(int seat);
  /// The team that plays on a side; empty: none has come yet.
  std::string teamOf(Side side) const;
  int port() const { return port_; }
  /// Agents that were sent away.
  long refused() const;

 private:
  struct Lobby;
  void seat(const std::shared_ptr<FrameChannel>& channel, const FrameBytes& message);
  std::optional<Side> sideOf(const std::string& team) const;
  int freeSeat(const AgentRequest& request, std::string& problem);
  void sendAway(const std::shared_ptr<FrameChannel>& channel, const std::string& why);

  std::shared_ptr<FrameServer> server_;
  mutable std::mutex mutex_;  // of all below but lobby_, never held while somebody waits
  std::vector<Seat> seats_;
  std::vector<std::shared_ptr<FrameChannel>> sitting_;  // as seats_
  std::array<std::string, 2> teams_;
  std::shared_ptr<Lobby> lobby_;  // those without a seat; the server may outlive the desk
  std::string host_;
  int wanted_port_ = -1, port_ = 0;
  long refused_ = 0;
};

}  // namespace murosimf::agent_server
