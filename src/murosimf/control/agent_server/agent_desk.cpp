#include "murosimf/control/agent_server/agent_desk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "murosimf/control/wire/s_expression.h"

namespace murosimf::agent_server {

namespace {

constexpr std::size_t kMostWaiting = 32;          // agents that have not said yet who they are
constexpr std::size_t kLongestName = 64;          // of a team or a model
constexpr std::size_t kLargestMessage = 1 << 16;  // [bytes]

std::string smallLetters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string printable(std::string text) {
  for (char& c : text) c = std::isprint(static_cast<unsigned char>(c)) != 0 && c != '"' ? c : '?';
  return text;
}

std::size_t indexOf(Side side) { return side == Side::kLeft ? 0 : 1; }
const char* nameOf(Side side) { return side == Side::kLeft ? "left" : "right"; }

}  // namespace

/// What the thread of the sockets and the desk share.
struct AgentDesk::Lobby {
  std::mutex mutex;
  bool open = true;
  std::vector<std::shared_ptr<FrameChannel>> waiting;  // in the order in which they came

  /// Who is silent for longest has to go where there is no more room.
  std::shared_ptr<FrameChannel> enter() {
    const std::lock_guard lock(mutex);
    if (!open) return nullptr;
    if (waiting.size() >= kMostWaiting) {
      waiting.front()->disconnect();
      waiting.erase(waiting.begin());
    }
    ChannelLimits limits;
    limits.largest_frame = kLargestMessage;
    return waiting.emplace_back(std::make_shared<FrameChannel>(limits));
  }
};

std::optional<AgentRequest> readAgentRequest(std::string_view message, std::string& problem) {
  const std::optional<std::vector<SExpression>> all = readSExpressions(message, problem);
  if (!all) return std::nullopt;
  const SExpression* init = nullptr;
  for (const SExpression& e : *all)
    if (e.isList() && e.name() == "init") init = &e;
  const std::optional<double> number = init == nullptr ? std::nullopt : init->number(3);
  if (!number || init->items.size() != 4 || init->text(1).empty() || init->text(2).empty()) {
    problem = "expected (init MODEL TEAM NUMBER), as in (init T1 Ours 1)";
    return std::nullopt;
  }
  if (init->text(1).size() > kLongestName || init->text(2).size() > kLongestName || *number != std::floor(*number) ||
      *number < 0 || *number > 99) {
    problem = fmt::format("expected names of at most {} letters and a number from 0 to 99", kLongestName);
    return std::nullopt;
  }
  return AgentRequest{std::string(init->text(1)), std::string(init->text(2)), static_cast<int>(*number)};
}

AgentDesk::AgentDesk(std::shared_ptr<FrameServer> server)
    : server_(std::move(server)), lobby_(std::make_shared<Lobby>()) {}

AgentDesk::~AgentDesk() {
  const std::lock_guard lock(lobby_->mutex);
  lobby_->open = false;
  for (const auto& channel : lobby_->waiting) channel->disconnect();
  for (const auto& channel : sitting_)
    if (channel != nullptr) channel->disconnect();
}

int AgentDesk::addSeat(const Seat& seat) {
  const std::lock_guard lock(mutex_);
  for (const Seat& other : seats_) {
    if (other.side == seat.side && other.number == seat.number)
      throw std::invalid_argument(
          fmt::format("two robots with the number {} on the {}", seat.number, nameOf(seat.side)));
  }
  std::string& team = teams_[indexOf(seat.side)];
  if (!seat.team.empty() && !team.empty() && team != seat.team)
    throw std::invalid_argument(
        fmt::format("the {} team is called \"{}\" and \"{}\"", nameOf(seat.side), team, seat.team));
  if (!seat.team.empty()) team = seat.team;
  seats_.push_back(seat);
  sitting_.push_back(nullptr);
  return static_cast<int>(seats_.size()) - 1;
}

void AgentDesk::listen(const FramePort& port) {
  const std::lock_guard lock(mutex_);
  if (wanted_port_ >= 0) {
    if (port.port == wanted_port_ && port.host == host_) return;
    throw std::invalid_argument(fmt::format("agents of one game have one port, here are {}:{} and {}:{}", host_,
                                            wanted_port_, port.host, port.port));
  }
  FramePort mine = port;
  mine.free_channel = [lobby = lobby_] { return lobby->enter(); };
  port_ = server_->listen(std::move(mine));
  wanted_port_ = port.port, host_ = port.host;
}

void AgentDesk::attend() {
  std::vector<std::pair<std::shared_ptr<FrameChannel>, FrameBytes>> said;
  {
    const std::lock_guard lock(lobby_->mutex);
    std::erase_if(lobby_->waiting, [&](const std::shared_ptr<FrameChannel>& channel) {
      std::optional<FrameBytes> frame = channel->receive();
      if (frame) said.emplace_back(channel, std::move(*frame));
      return frame || (channel->connection() > 0 && !channel->isConnected());
    });
  }
  for (const auto& [channel, message] : said) seat(channel, message);
}

void AgentDesk::seat(const std::shared_ptr<FrameChannel>& channel, const FrameBytes& message) {
  std::string problem;
  const std::string_view text(reinterpret_cast<const char*>(message.data()), message.size());
  const std::optional<AgentRequest> request = readAgentRequest(text, problem);
  const std::lock_guard lock(mutex_);
  const int place = request ? freeSeat(*request, problem) : -1;
  if (place < 0) return sendAway(channel, problem);
  const auto i = static_cast<std::size_t>(place);
  teams_[indexOf(seats_[i].side)] = request->team;
  sitting_[i] = channel;
}

std::optional<Side> AgentDesk::sideOf(const std::string& team) const {
  for (const Side side : {Side::kLeft, Side::kRight})
    if (teams_[indexOf(side)] == team) return side;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const bool plays = std::any_of(seats_.begin(), seats_.end(), [&](const Seat& s) { return s.side == side; });
    if (plays && teams_[indexOf(side)].empty()) return side;
  }
  return std::nullopt;
}

/// -1 and why, where there is none.
int AgentDesk::freeSeat(const AgentRequest& request, std::string& problem) {
  const std::optional<Side> side = sideOf(request.team);
  problem = fmt::format("team \"{}\" does not play, but \"{}\" and \"{}\"", request.team, teams_[0], teams_[1]);
  if (!side) return -1;
  problem = fmt::format("no robot with number {} on the {}", request.number, nameOf(*side));
  for (std::size_t i = 0; i < seats_.size(); ++i) {
    const Seat& seat = seats_[i];
    if (seat.side != *side || (request.number != 0 && seat.number != request.number)) continue;
    problem = fmt::format("robot {} on the {} has its agent", seat.number, nameOf(*side));
    if (sitting_[i] != nullptr && sitting_[i]->isConnected()) continue;
    problem =
        fmt::format("robot {} on the {} is a {}, not a {}", seat.number, nameOf(*side), seat.model, request.model);
    if (smallLetters(seat.model) == smallLetters(request.model)) return static_cast<int>(i);
  }
  return -1;
}

void AgentDesk::sendAway(const std::shared_ptr<FrameChannel>& channel, const std::string& why) {
  const std::string text = fmt::format("(error \"{}\")", printable(why));
  channel->send(FrameBytes(text.begin(), text.end()));
  channel->disconnect();
  ++refused_;
}

std::shared_ptr<FrameChannel> AgentDesk::channelOf(int seat) {
  const std::lock_guard lock(mutex_);
  const std::shared_ptr<FrameChannel>& channel = sitting_[static_cast<std::size_t>(seat)];
  return channel != nullptr && channel->isConnected() ? channel : nullptr;
}

std::string AgentDesk::teamOf(Side side) const {
  const std::lock_guard lock(mutex_);
  return teams_[indexOf(side)];
}

long AgentDesk::refused() const {
  const std::lock_guard lock(mutex_);
  return refused_;
}

}  // namespace murosimf::agent_server
