#include "murosimf/control/agent_server/agent_port.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace murosimf::agent_server {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRadians = kPi / 180;
constexpr double kHoldingError = 0.1;   // angle at which a motor that nobody has asked gives all its torque [rad]
constexpr double kHoldingTime = 0.05;   // kd over kp of such a motor [s]
constexpr std::size_t kMotorWords = 6;  // (name q dq kp kd tau)
constexpr auto kLook = std::chrono::milliseconds(1);  // between two looks for agents before the game

double secondsNow() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }
Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// tau = kp (q - q_now) + kd (dq - dq_now) + tau; nothing where a number is missing, or a gain is below zero.
std::optional<client::JointCommand> commandOf(const SExpression& e) {
  if (e.items.size() != kMotorWords) return std::nullopt;
  const auto q = e.number(1), dq = e.number(2), kp = e.number(3), kd = e.number(4), tau = e.number(5);
  if (!q || !dq || !kp || !kd || !tau || *kp < 0 || *kd < 0) return std::nullopt;
  return client::JointCommand{*q * kRadians, *dq * kRadians, *tau, *kp, *kd};
}

}  // namespace

AgentPort::AgentPort(std::shared_ptr<AgentDesk> desk, const AgentPortSettings& settings)
    : desk_(std::move(desk)), settings_(settings), budget_(settings.delay) {}

void AgentPort::start(const client::RobotDescription& robot) {
  robot_ = robot;
  side_ = robot.attacks_positive_x ? Side::kLeft : Side::kRight;
  writer_ = {robot, side_};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) motors_.emplace(robot.joints[i].name, i);
  FramePort port;
  port.host = settings_.host, port.port = settings_.port, port.allowed = settings_.allowed;
  try {
    seat_ = desk_->addSeat({side_, robot.number, robot.model, settings_.team});
    desk_->listen(port);
  } catch (const std::exception& problem) {
    throw client::CannotStart(problem.what());
  }
}

void AgentPort::startCameras(std::span<double> /*periods*/) {
  if (!settings_.lock_step) return;
  const Clock::time_point until = after(settings_.connect_wait);
  for (takeSeat(); channel_ == nullptr && Clock::now() < until; takeSeat()) std::this_thread::sleep_for(kLook);
}

void AgentPort::takeSeat() {
  desk_->attend();
  channel_ = desk_->channelOf(seat_);
}

void AgentPort::step(const client::SensorFrame& sensors, client::CommandFrame& commands) {
  takeSeat();
  if (targets_.empty()) holdPosture(sensors);
  if (sensors.game.phase == client::GamePhase::kPlaying) played_ += robot_.control_period;
  if (channel_ != nullptr) {
    for (std::size_t i = 0; !settings_.lock_step && i < channel_->limits().most_received; ++i) {
      const std::optional<FrameBytes> message = channel_->receive();
      if (!message) break;
      obey(*message);
    }
    sendPerceptions(sensors);
    if (settings_.lock_step) awaitActions();
  }
  commands.joints = targets_;
  commands.beams = beam_.has_value(), commands.beam = beam_.value_or(PlanarPose{});
  beam_.reset();
}

/// Until somebody asks for something.
void AgentPort::holdPosture(const client::SensorFrame& sensors) {
  for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
    const double kp = robot_.joints[i].largest_torque / kHoldingError;
    targets_.push_back({sensors.joints[i].position, 0, 0, kp, kHoldingTime * kp});
  }
}

void AgentPort::obey(const FrameBytes& message) {
  ++received_;
  std::string problem;
  const std::string_view text(reinterpret_cast<const char*>(message.data()), message.size());
  const std::optional<std::vector<SExpression>> all = readSExpressions(text, problem);
  if (!all) return void(++not_understood_);
  for (const SExpression& e : *all) {
    if (e.name() == "syn" || e.name() == "init") continue;
    if (e.name() == "beam") {
      obeyBeam(e);
      continue;
    }
    const auto motor = motors_.find(std::string(e.name()));
    const std::optional<client::JointCommand> command = commandOf(e);
    if (motor == motors_.end() || !command) {
      ++not_understood_;
    } else {
      targets_[motor->second] = *command;
    }
  }
}

/// (beam x y theta): x is a distance behind the middle line, y the field's, theta the team's own. In the left team's
/// frame (-|x|, y, theta), in the field's frame for the right team (|x|, y, theta + 180 degrees), which is (-|x|, -y,
/// theta) in its own.
void AgentPort::obeyBeam(const SExpression& e) {
  const auto x = e.number(1), y = e.number(2), theta = e.number(3);
  if (e.items.size() != 4 || !x || !y || !theta) return void(++not_understood_);
  beam_ = {-std::abs(*x), side_ == Side::kLeft ? *y : -*y, *theta * kRadians};
}

void AgentPort::sendPerceptions(const client::SensorFrame& sensors) {
  GameStanding game = standingOf(sensors, side_);
  game.played = played_;
  game.left = desk_->teamOf(Side::kLeft), game.right = desk_->teamOf(Side::kRight);
  const std::string text = writer_.write(sensors, game);
  FrameBytes bytes = channel_->spare();
  bytes.assign(text.begin(), text.end());
  channel_->send(std::move(bytes));
  ++sent_;
}

void AgentPort::awaitActions() {
  const double begun = secondsNow();
  const bool answered = channel_->waitForFrame(after(budget_.allowance(begun)));
  if (answered) obey(*channel_->receive());
  const double ended = secondsNow();
  if (answered) {
    budget_.answered(ended, ended - begun);
  } else if (channel_->isConnected() && !budget_.isLost()) {
    budget_.missed(ended, ended - begun);
  }
}

std::string AgentPort::address() const {
  return settings_.port == 0 ? settings_.host : fmt::format("{}:{}", settings_.host, settings_.port);
}

std::vector<std::pair<std::string, double>> AgentPort::figures() const {
  return {{"messages_sent", static_cast<double>(sent_)},
          {"messages_received", static_cast<double>(received_)},
          {"not_understood", static_cast<double>(not_understood_)},
          {"missed_answers", static_cast<double>(budget_.misses())},
          {"refused_agents", static_cast<double>(desk_->refused())}};
}

void AgentPort::archive(client::StateArchive& archive) { archive(targets_, played_); }

}  // namespace murosimf::agent_server
