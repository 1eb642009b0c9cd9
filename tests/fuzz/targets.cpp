#include "fuzz/targets.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include "murosimf/control/agent_server/agent_desk.h"
#include "murosimf/control/game_controller/packets.h"
#include "murosimf/control/player_api/request_reader.h"
#include "murosimf/control/servo_bus/bus.h"
#include "murosimf/control/servo_bus/packet_reader.h"
#include "murosimf/control/servo_bus/servo_tables.h"
#include "murosimf/control/wire/frame_parser.h"
#include "murosimf/control/wire/s_expression.h"

namespace murosimf::fuzz {

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// The first byte says how large the pieces are in which the others arrive.
void parseFrames(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return;
  constexpr std::size_t kLargest = 1000;
  const std::size_t piece = bytes[0] % 7 + 1U;
  FrameParser parser(kLargest);
  for (std::size_t i = 1; i < bytes.size(); i += piece) {
    std::span<const std::uint8_t> part = bytes.subspan(i, std::min(piece, bytes.size() - i));
    while (!part.empty()) {
      if (parser.take(part)) require(parser.frame().size() == parser.announced());
      require(parser.frame().size() <= kLargest);
    }
  }
}

void readExpressions(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  std::string problem;
  const auto all = readSExpressions(text, problem, {8, 200});
  require(all.has_value() == problem.empty());
  if (!all) return;
  for (const SExpression& e : *all) {
    for (std::size_t i = 0; i < e.items.size(); ++i) require(std::isfinite(e.number(i).value_or(0)));
  }
}

/// Whatever a client asks, each joint gets a command that physics can bear.
void readRequests(std::span<const std::uint8_t> bytes) {
  using namespace player_api;
  using client::DeviceKind;
  static const DeviceBook devices({{DeviceKind::kMotor, "m", 0},
                                   {DeviceKind::kMotor, "n", 1, -1, 2, 1},
                                   {DeviceKind::kPositionSensor, "p", 0},
                                   {DeviceKind::kCamera, "c", 0}});
  MotorTable motors({{"m", -1, 1, 5, 2}, {"n", 0, 0, 0, 0}});
  SensorSchedule sensors(devices, {{640, 480}}, 8, 100);
  RequestReader reader(devices, motors, sensors);
  std::vector<std::string> warnings;
  reader.read(bytes, 8, warnings);
  require(warnings.size() <= RequestReader::kMostWarnings + 1);
  std::vector<client::JointCommand> commands;
  const std::vector<client::JointReading> joints(2);
  motors.fill(joints, false, commands);
  for (const client::JointCommand& c : commands) {
    require(std::isfinite(c.position) && std::isfinite(c.velocity) && std::isfinite(c.torque));
    require(std::isfinite(c.kp) && std::isfinite(c.kd) && c.kp >= 0 && c.kd >= 0);
  }
}

/// What can be read of a game controller's packet is written as the same bytes again, but for what we do not keep.
void readGamePackets(std::span<const std::uint8_t> bytes) {
  using namespace game_controller;
  std::string problem;
  if (const auto control = decodeControl(bytes, problem)) {
    const Bytes again = encodeControl(control->game, control->format);
    const auto twice = decodeControl(again, problem);
    require(twice.has_value() && twice->game == control->game);
  }
  if (const auto status = decodeStatus(bytes, problem)) require(std::isfinite(status->x));
  static_cast<void>(decodeMessage(bytes, problem));
}

/// Whoever an agent says that it is, its names are short and its number is one.
void readAgentRequests(std::span<const std::uint8_t> bytes) {
  std::string problem;
  const auto request = agent_server::readAgentRequest(std::string(bytes.begin(), bytes.end()), problem);
  require(request.has_value() || !problem.empty());
  if (request) require(request->number >= 0 && request->number < 100 && request->team.size() <= 64);
}

/// The first byte chooses the version of the protocol and how large the pieces are in which the others arrive; whatever
/// comes is followed by two servos and, in 2.0, by a board.
void readServoPackets(std::span<const std::uint8_t> bytes) {
  using namespace servo_bus;
  if (bytes.empty()) return;
  const Protocol protocol = bytes[0] % 2 == 0 ? Protocol::k1 : Protocol::k2;
  const std::size_t piece = bytes[0] / 2 % 7 + 1U;
  std::vector<Device> devices{{tableOf("MX-28", protocol), 1, 0}, {tableOf("MX-106", protocol), 2, 0}};
  if (protocol == Protocol::k2) devices.emplace_back(tableOf("IMU", protocol), std::uint8_t{3}, std::uint8_t{0});
  PacketReader reader(protocol);
  Bus bus(protocol, std::move(devices));
  for (std::size_t i = 1; i < bytes.size(); i += piece) {
    reader.take(bytes.subspan(i, std::min(piece, bytes.size() - i)));
    while (const auto packet = reader.next()) {
      for (const Answer& answer : bus.handle(*packet)) require(answer.bytes.size() < (1U << 17) && answer.delay >= 0);
    }
    require(reader.pending() < (1U << 17));
  }
}

}  // namespace

const std::vector<Target>& allTargets() {
  static const std::vector<Target> targets{
      {"frames", parseFrames},           {"s_expressions", readExpressions},    {"player_requests", readRequests},
      {"game_packets", readGamePackets}, {"agent_requests", readAgentRequests}, {"servo_packets", readServoPackets}};
  return targets;
}

}  // namespace murosimf::fuzz
