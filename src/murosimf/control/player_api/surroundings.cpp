#include "murosimf/control/player_api/surroundings.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/control/player_api/player_api.pb.h"

namespace murosimf::player_api {

namespace {

murosimf::PlanarPose poseOf(const PlanarPose& p) { return {p.x(), p.y(), p.heading()}; }
void setPose(const murosimf::PlanarPose& p, PlanarPose& out) {
  out.set_x(p.x), out.set_y(p.y), out.set_heading(p.heading);
}

murosimf::Vector3 vectorOf(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
void setVector(const murosimf::Vector3& v, Vector3& out) { out.set_x(v.x), out.set_y(v.y), out.set_z(v.z); }

client::ToldPose toldOf(const ToldPose& t) { return {t.number(), t.valid(), t.time(), poseOf(t.pose())}; }
void setTold(const client::ToldPose& t, ToldPose& out) {
  out.set_number(t.number), out.set_valid(t.valid), out.set_time(t.time);
  setPose(t.pose, *out.mutable_pose());
}

client::GameInfo gameOf(const Game& g) {
  client::GameInfo game;
  game.phase = static_cast<client::GamePhase>(std::min(g.phase(), 3U));
  game.own_kickoff = g.own_kickoff(), game.penalised = g.penalised(), game.sent_off = g.sent_off();
  game.time_left = g.time_left();
  game.own_score = g.own_score(), game.opponent_score = g.opponent_score();
  game.restart_count = g.restart_count();
  game.placed = g.placed(), game.placed_at = poseOf(g.placed_at());
  return game;
}

void setGame(const client::GameInfo& g, Game& out) {
  out.set_phase(static_cast<std::uint32_t>(g.phase));
  out.set_own_kickoff(g.own_kickoff), out.set_penalised(g.penalised), out.set_sent_off(g.sent_off);
  out.set_time_left(g.time_left);
  out.set_own_score(g.own_score), out.set_opponent_score(g.opponent_score);
  out.set_restart_count(g.restart_count);
  out.set_placed(g.placed);
  setPose(g.placed_at, *out.mutable_placed_at());
}

void setSights(const client::CameraSights& s, const client::RobotDescription& robot, Sights& out) {
  out.set_camera(robot.cameras[static_cast<std::size_t>(s.camera)].name);
  out.set_kind(static_cast<std::uint32_t>(s.kind));
  out.set_time(s.time);
  for (const client::SeenThing& thing : s.things) {
    SeenThing& t = *out.add_things();
    setVector(thing.p_C, *t.mutable_p_c());
    setVector(thing.q_C, *t.mutable_q_c());
    t.set_mark(std::string(thing.mark));
    t.set_number(thing.number);
  }
}

int cameraNamed(const client::RobotDescription& robot, const std::string& name) {
  for (std::size_t i = 0; i < robot.cameras.size(); ++i) {
    if (robot.cameras[i].name == name) return static_cast<int>(i);
  }
  throw std::runtime_error(fmt::format("sights of camera \"{}\", which the description does not have", name));
}

}  // namespace

client::TeamMessage clientMessage(const TeamMessage& m) {
  return {m.number(), poseOf(m.pose()), m.ball_x(), m.ball_y(), m.ball_age(), m.cost_to_ball()};
}

void setMessage(const client::TeamMessage& m, TeamMessage& out) {
  out.set_number(m.number);
  setPose(m.pose, *out.mutable_pose());
  out.set_ball_x(m.ball_x), out.set_ball_y(m.ball_y), out.set_ball_age(m.ball_age);
  out.set_cost_to_ball(m.cost_to_ball);
}

void writeSurroundings(const client::SensorFrame& sensors, const client::RobotDescription& robot, Surroundings& out) {
  out.set_time(sensors.time);
  setGame(sensors.game, *out.mutable_game());
  for (const client::TeamMessage& message : sensors.team_messages) setMessage(message, *out.add_team_messages());
  if (sensors.own_pose.valid) setTold(sensors.own_pose, *out.mutable_own_pose());
  for (const client::ToldPose& mate : sensors.mate_poses) setTold(mate, *out.add_mate_poses());
  for (const client::CameraSights& sights : sensors.sights) setSights(sights, robot, *out.add_sights());
  for (const std::uint8_t touches : sensors.sole_touches) out.add_sole_touches(touches != 0);
}

void SurroundingsReader::read(const Surroundings& from, const client::RobotDescription& robot,
                              client::SensorFrame& sensors) {
  sensors.time = from.time();
  sensors.game = gameOf(from.game());
  messages_.clear(), mates_.clear(), things_.clear(), sights_.clear(), sole_touches_.clear();
  for (const TeamMessage& message : from.team_messages()) messages_.push_back(clientMessage(message));
  sensors.team_messages = messages_;
  sensors.own_pose = toldOf(from.own_pose());
  for (const ToldPose& mate : from.mate_poses()) mates_.push_back(toldOf(mate));
  sensors.mate_poses = mates_;
  for (const Sights& s : from.sights()) {
    std::vector<client::SeenThing>& things = things_.emplace_back();
    for (const SeenThing& t : s.things())
      things.push_back({vectorOf(t.p_c()), vectorOf(t.q_c()), t.mark(), t.number()});
    sights_.push_back({cameraNamed(robot, s.camera()), static_cast<client::ThingKind>(s.kind()), s.time(), things});
  }
  sensors.sights = sights_;
  for (const bool touches : from.sole_touches()) sole_touches_.push_back(touches ? 1 : 0);
  sensors.sole_touches = sole_touches_;
}

}  // namespace murosimf::player_api
