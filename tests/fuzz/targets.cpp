#include "fuzz/targets.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include "murosimf/control/game_controller/packets.h"
#include "murosimf/control/player_api/request_reader.h"
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

}  // namespace

const std::vector<Target>& allTargets() {
  static const std::vector<Target> targets{{"frames", parseFrames},
                                           {"s_expressions", readExpressions},
                                           {"player_requests", readRequests},
                                           {"game_packets", readGamePackets}};
  return targets;
}

}  // namespace murosimf::fuzz
