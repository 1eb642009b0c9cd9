#include "murosimf/control/agent_server/perceptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace murosimf::agent_server {

namespace {

constexpr double kDegrees = 180 / kPi;

template <class... Values>
void add(std::string& out, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

/// A number cut behind the second or third digit; no minus before a zero.
std::string cut(double value, int digits = 2) {
  const double scale = digits == 2 ? 100 : 1000;
  return fmt::format("{:.{}f}", std::trunc(value * scale) / scale + 0.0, digits);
}

std::string cutVector(const Vector3& v, int digits = 2) {
  return fmt::format("{} {} {}", cut(v.x, digits), cut(v.y, digits), cut(v.z, digits));
}

/// w x y z, w >= 0 [Shepperd 1978].
std::array<double, 4> quaternionOf(const Rotation<>& r) {
  const double trace = r.x.x + r.y.y + r.z.z;
  const std::array<double, 4> squares{(1 + trace) / 4, (1 + 2 * r.x.x - trace) / 4, (1 + 2 * r.y.y - trace) / 4,
                                      (1 + 2 * r.z.z - trace) / 4};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const double a = std::sqrt(squares[static_cast<std::size_t>(largest)]), b = 1 / (4 * a);
  const double wx = (r.y.z - r.z.y) * b, wy = (r.z.x - r.x.z) * b, wz = (r.x.y - r.y.x) * b;
  const double xy = (r.x.y + r.y.x) * b, xz = (r.z.x + r.x.z) * b, yz = (r.y.z + r.z.y) * b;
  std::array<double, 4> q{a, wx, wy, wz};
  if (largest == 1) q = {wx, a, xy, xz};
  if (largest == 2) q = {wy, xy, a, yz};
  if (largest == 3) q = {wz, xz, yz, a};
  if (q[0] < 0) q = {-q[0], -q[1], -q[2], -q[3]};
  return q;
}

void writeGame(const GameStanding& g, std::string& out) {
  add(out, "(time (now {}))(GS (t {})(pm {})", cut(g.now), cut(g.played), g.mode);
  if (!g.left.empty()) add(out, "(tl {})", g.left);
  if (!g.right.empty()) add(out, "(tr {})", g.right);
  add(out, "(sl {})(sr {}))", g.score_left, g.score_right);
}

std::string pol(const Vector3& p_C) {
  const PolarPoint p = polarOf(p_C);
  return fmt::format("(pol {} {} {})", cut(p.distance), cut(p.azimuth), cut(p.elevation));
}

}  // namespace

GameStanding standingOf(const client::SensorFrame& sensors, Side side) {
  GameStanding g;
  g.now = sensors.time;
  const client::GameInfo& game = sensors.game;
  g.score_left = side == Side::kLeft ? game.own_score : game.opponent_score;
  g.score_right = side == Side::kLeft ? game.opponent_score : game.own_score;
  if (game.phase == client::GamePhase::kPlaying) {
    g.mode = "PlayOn";
  } else if (game.phase == client::GamePhase::kFinished) {
    g.mode = "GameOver";
  } else if (g.score_left + g.score_right == 0) {
    g.mode = "BeforeKickOff";
  } else {
    g.mode = game.own_kickoff == (side == Side::kLeft) ? "Goal_Right" : "Goal_Left";
  }
  return g;
}

std::string jointSensorOf(const std::string& motor) {
  std::string name = motor;
  const std::size_t e = name.rfind('e');
  const bool numbered =
      e != name.npos && e + 1 < name.size() && name.find_first_not_of("0123456789", e + 1) == name.npos && e <= 2;
  if (numbered) name[e] = 'j';
  return "q_" + name;
}

PolarPoint polarOf(const Vector3& p_C) {
  const double x = p_C.z, y = -p_C.x, z = -p_C.y;  // forward, left, up
  return {norm(p_C), std::atan2(y, x) * kDegrees, std::atan2(z, std::hypot(x, y)) * kDegrees};
}

PerceptionWriter::PerceptionWriter(const client::RobotDescription& robot, Side side) : side_(side), team_(robot.team) {
  for (const client::JointDescription& joint : robot.joints) joints_.push_back(jointSensorOf(joint.name));
}

std::string PerceptionWriter::write(const client::SensorFrame& sensors, const GameStanding& game) const {
  std::string out;
  writeGame(game, out);
  writePose(sensors.own_pose, out);
  add(out, "(GYR (n torso_gyro)(rt {}))", cutVector(kDegrees * sensors.angular_velocity));
  add(out, "(ACC (n torso_acc)(a {}))", cutVector(sensors.specific_force));
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const client::JointReading& joint = sensors.joints[i];
    add(out, "(HJ (n {})(ax {})(vx {}))", joints_[i], cut(joint.position * kDegrees), cut(joint.velocity * kDegrees));
  }
  writeSights(sensors, out);
  return out;
}

/// In the field's frame, in which the left team attacks +x: that of the right team's own, turned by half a turn.
void PerceptionWriter::writePose(const client::ToldPose& told, std::string& out) const {
  if (!told.valid) return;
  const Pose turn{side_ == Side::kLeft ? Rotation<>{} : Rotation<>{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {}};
  const Pose X_FB = turn * told.X_FB;
  const std::array<double, 4> q = quaternionOf(X_FB.rotation);
  add(out, "(quat (n torso_quat)(q {} {}))", cut(q[0], 3), cutVector({q[1], q[2], q[3]}, 3));
  add(out, "(pos (n torso_pos)(p {}))", cutVector(X_FB.translation, 3));
}

void PerceptionWriter::writeSights(const client::SensorFrame& sensors, std::string& out) const {
  if (sensors.sights.empty()) return;
  out += "(See";
  for (const client::CameraSights& sights : sensors.sights) {
    for (const client::SeenThing& thing : sights.things) {
      if (sights.kind == client::ThingKind::kBall) add(out, " (B {})", pol(thing.p_C));
      if (sights.kind == client::ThingKind::kPost) add(out, " (G {})", pol(thing.p_C));
      if (sights.kind != client::ThingKind::kRobot) continue;
      const bool left = (thing.mark == team_) == (side_ == Side::kLeft);
      add(out, " (P (team {})(id {})(base {}))", left ? 0 : 1, thing.number, pol(thing.p_C));
    }
  }
  out += ')';
}

}  // namespace murosimf::agent_server
