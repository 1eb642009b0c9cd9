#include <fmt/format.h>

#include <cmath>

#include "murosimf/control/game_controller/byte_order.h"
#include "murosimf/control/game_controller/packets.h"

namespace murosimf::game_controller {

namespace {

constexpr int kStatusVersion = 4, kMessageVersion = 2;
constexpr std::size_t kStatusBytes = 32, kMessageBytes = 8;
constexpr float kMillimetres = 1000;

bool isHeader(std::span<const std::uint8_t> bytes, int version, std::size_t size, std::string& problem) {
  if (bytes.size() < 5 || std::string(bytes.begin(), bytes.begin() + 4) != "RGrt") {
    problem = fmt::format("{} bytes that do not begin with RGrt", bytes.size());
  } else if (bytes[4] != version || bytes.size() != size) {
    problem =
        fmt::format("RGrt of version {} in {} bytes, expected version {} in {}", bytes[4], bytes.size(), version, size);
  } else {
    return true;
  }
  return false;
}

bool isPlayer(int player, std::string& problem) {
  if (player >= 1 && player <= kMostPlayers) return true;
  problem = fmt::format("player {}, expected 1 to {}", player, kMostPlayers);
  return false;
}

}  // namespace

Bytes encodeStatus(const RobotStatus& s) {
  LittleEndianWriter out;
  out.text("RGrt");
  out.u8(kStatusVersion);
  out.u8(s.player);
  out.u8(s.team);
  out.u8(s.fallen ? 1 : 0);
  for (const float value : {s.x * kMillimetres, s.y * kMillimetres, s.heading, s.ball_age, s.ball_x * kMillimetres,
                            s.ball_y * kMillimetres})
    out.f32(value);
  return out.take();
}

Bytes encodeMessage(const RobotMessage& m) {
  LittleEndianWriter out;
  out.text("RGrt");
  out.u8(kMessageVersion);
  out.u8(m.team);
  out.u8(m.player);
  out.u8(static_cast<int>(m.kind));
  return out.take();
}

std::optional<RobotStatus> decodeStatus(std::span<const std::uint8_t> bytes, std::string& problem) {
  if (!isHeader(bytes, kStatusVersion, kStatusBytes, problem)) return std::nullopt;
  LittleEndianReader in(bytes.subspan(5));
  RobotStatus s;
  s.player = in.u8(), s.team = in.u8();
  if (!isPlayer(s.player, problem)) return std::nullopt;
  const int fallen = in.u8();
  if (fallen > 1) {
    problem = fmt::format("fallen is {}, expected 0 or 1", fallen);
    return std::nullopt;
  }
  s.fallen = fallen == 1;
  for (float* value : {&s.x, &s.y, &s.heading, &s.ball_age, &s.ball_x, &s.ball_y}) {
    *value = in.f32();
    if (std::isfinite(*value)) continue;
    problem = "a place or an age that is no finite number";
    return std::nullopt;
  }
  for (float* length : {&s.x, &s.y, &s.ball_x, &s.ball_y}) *length /= kMillimetres;
  return s;
}

std::optional<RobotMessage> decodeMessage(std::span<const std::uint8_t> bytes, std::string& problem) {
  if (!isHeader(bytes, kMessageVersion, kMessageBytes, problem)) return std::nullopt;
  LittleEndianReader in(bytes.subspan(5));
  RobotMessage m;
  m.team = in.u8(), m.player = in.u8();
  if (!isPlayer(m.player, problem)) return std::nullopt;
  const int kind = in.u8();
  if (kind > static_cast<int>(RobotMessage::Kind::kReadyAfterInterruption)) {
    problem = fmt::format("message {}, expected 0 to 4", kind);
    return std::nullopt;
  }
  m.kind = static_cast<RobotMessage::Kind>(kind);
  return m;
}

}  // namespace murosimf::game_controller
