#include "toy_game.h"

#include <cmath>

namespace murosimf::controllers {

namespace {

constexpr double kDt = 0.01, kBallRadius = 0.07, kRolling = 0.3, kSliding = 4.0, kBounce = 0.5;
constexpr double kApart = 0.22;  // two robots' middles are no closer than this [m]

PlanarPose turnedField(const PlanarPose& pose, int team) {
  return team == 0 ? pose : PlanarPose{-pose.x, -pose.y, wrapAngle(pose.heading + kPi)};
}
Point turnedField(const Point& p, int team) { return team == 0 ? p : Point{-p.x, -p.y}; }

/// Half angles of view of head and chest camera [rad].
constexpr std::array<std::array<double, 2>, 2> kHalfAngle{{{degrees(30), degrees(23)}, {degrees(50), degrees(42)}}};

}  // namespace

bool ExactEyes::sees(const Pose& X_RC, const Vector3& p_R, std::size_t camera) {
  const Vector3 p_C = applyInverse(X_RC, p_R);
  return p_C.z > 0.05 && std::fabs(atan2(p_C.x, p_C.z)) < kHalfAngle[camera][0] &&
         std::fabs(atan2(p_C.y, p_C.z)) < kHalfAngle[camera][1];
}

void ExactEyes::process(const client::SensorFrame& sensors, const CameraPast& past, Percepts& out) {
  out.clear();
  for (const client::CameraPicture& picture : sensors.pictures) {
    const auto camera = static_cast<std::size_t>(picture.camera);
    const Pose X_RC = past.pose(camera, picture.time);
    const Point ball = transformedBack(view_->X_FR, view_->ball_F);
    if (sees(X_RC, {ball.x, ball.y, kBallRadius}, camera)) out.balls.push_back({ball.x, ball.y, 0.02});
    for (const Point& robot_F : view_->robots_F) {
      const Point p = transformedBack(view_->X_FR, robot_F);
      if (sees(X_RC, {p.x, p.y, 0.1}, camera)) out.robots.push_back({p.x, p.y});
    }
    const auto landmark = [&](const Point& p_F, LandmarkColour colour, std::vector<LandmarkPercept>& list) {
      const Point p = transformedBack(view_->X_FR, p_F);
      if (sees(X_RC, {p.x, p.y, 0.2}, camera)) list.push_back({colour, direction(p), norm(p), 0.02, 0.1, true});
    };
    const bool attacks_yellow = robot_.goal_colour_attacked == "yellow";
    for (const double end : {-1.0, 1.0}) {
      const LandmarkColour colour = (end > 0) == attacks_yellow ? LandmarkColour::kYellow : LandmarkColour::kBlue;
      for (const double side : {-1.0, 1.0}) {
        const double y = 0.5 * robot_.field.goal_width + robot_.field.post_radius;
        landmark({end * 0.5 * robot_.field.length, side * y}, colour, out.posts);
      }
    }
  }
}

ToyGame::ToyGame(const std::vector<Entry>& entries, const Point& ball) {
  for (const Entry& entry : entries) {
    auto robot = std::make_unique<Robot>();
    robot->entry = entry;
    robot->puppet = Puppet(turnedField(entry.pose, entry.team));
    robot->puppet.move(walkingPose({}, 0, 0, {}));
    client::RobotDescription description = makeRobot();
    description.number = entry.number, description.role = entry.role;
    description.attacks_positive_x = entry.team == 0;
    description.goal_colour_attacked = "yellow", description.goal_colour_defended = "blue";
    robot->player = std::make_unique<Player>(std::make_unique<ExactEyes>(&robot->view));
    robot->player->start(description);
    robot->commands.joints.resize(kJointCount);
    starts_.push_back(entry.pose);
    robots_.push_back(std::move(robot));
  }
  ball_.p = ball;
  kickOff(0);
  wait_ = 0, ball_.p = ball;
}

PlanarPose ToyGame::pose(std::size_t i) const { return robots_[i]->puppet.pose(); }

void ToyGame::continueFrom(const ToyGame& other, const client::StateArchive& players) {
  client::StateArchive reading(players.bytes());
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i]->puppet = other.robots_[i]->puppet;
    robots_[i]->sent = other.robots_[i]->sent, robots_[i]->placed = other.robots_[i]->placed;
    robots_[i]->player->archive(reading);
  }
  ball_ = other.ball_, time_ = other.time_, wait_ = other.wait_;
  kickoff_team_ = other.kickoff_team_, restarts_ = other.restarts_, score_ = other.score_;
}

void ToyGame::stepRobot(Robot& robot) {
  const int team = robot.entry.team;
  robot.view.X_FR = turnedField(robot.puppet.pose(), team);
  robot.view.ball_F = turnedField(ball_.p, team);
  robot.view.robots_F.clear();
  std::vector<client::TeamMessage> messages;
  for (const auto& other : robots_) {
    if (other.get() == &robot) continue;
    const PlanarPose p = turnedField(other->puppet.pose(), team);
    robot.view.robots_F.push_back({p.x, p.y});
    if (other->entry.team == team && other->sent.number != 0) messages.push_back(other->sent);
  }
  const int tick = static_cast<int>(time_ / kDt + 0.5);
  std::vector<client::CameraPicture> pictures;
  if (tick % 5 == 0) pictures.push_back({0, time_, 640, 480, {}});
  if (tick % 10 == 0) pictures.push_back({1, time_, 320, 240, {}});
  client::SensorFrame sensors;
  sensors.time = time_;
  sensors.joints = robot.puppet.readings();
  sensors.pictures = pictures;
  sensors.team_messages = messages;
  sensors.game.phase = wait_ > 0 ? client::GamePhase::kSet : client::GamePhase::kPlaying;
  sensors.game.own_kickoff = kickoff_team_ == team;
  sensors.game.restart_count = restarts_;
  sensors.game.placed = robot.placed, sensors.game.placed_at = robot.view.X_FR;
  robot.placed = false;
  robot.player->step(sensors, robot.commands);
}

void ToyGame::step() {
  for (auto& robot : robots_) stepRobot(*robot);
  std::vector<std::array<Pose, 2>> soles;
  for (auto& robot : robots_) {
    const Pose X_FR = toPose(robot->puppet.pose());
    soles.push_back({X_FR * robot->puppet.posture().X_RF[0], X_FR * robot->puppet.posture().X_RF[1]});
    robot->sent = robot->commands.message;
    JointAngles angles{};
    for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = robot->commands.joints[i].position;
    const PlanarPose before = robot->puppet.pose();
    robot->puppet.move(angles);
    keepApart(*robot, before);
  }
  rollBall(soles);
  time_ += kDt;
  wait_ -= kDt;
  if (play_on) referee();
}

void ToyGame::keepApart(Robot& robot, const PlanarPose& before) {
  for (const auto& other : robots_) {
    if (other.get() == &robot) continue;
    const Point o{other->puppet.pose().x, other->puppet.pose().y};
    const double now = norm(o - Point{robot.puppet.pose().x, robot.puppet.pose().y});
    if (now < kApart && now < norm(o - Point{before.x, before.y}))
      robot.puppet.place({before.x, before.y, robot.puppet.pose().heading});
  }
}

/// Pushes the ball out along the normal and gives it at least the surface's speed, restitution included.
void ToyGame::touch(const Point& p, const Point& normal, double depth, const Point& surface_velocity) {
  ball_.p = p + depth * normal;
  const double approach = dot(ball_.v - surface_velocity, normal);
  if (approach < 0) ball_.v = ball_.v - ((1 + kBounce) * approach) * normal;
}

/// Sliding friction a slows the ball by a and spins it up by a / beta until it rolls; beta = 2/3 for a thin shell.
void ToyGame::slideAndRoll() {
  const Point slip = ball_.v - ball_.rolling;
  const double slipping = norm(slip), beta = 2.0 / 3;
  if (slipping > 1e-9) {
    const double change = std::min(kSliding * kDt, slipping / (1 + 1 / beta));
    ball_.v = ball_.v - (change / slipping) * slip;
    ball_.rolling = ball_.rolling + (change / beta / slipping) * slip;
  }
  const double speed = norm(ball_.v);
  const double kept = speed > 0 ? std::max(0.0, speed - kRolling * kDt) / speed : 0.0;
  ball_.v = kept * ball_.v, ball_.rolling = kept * ball_.rolling;
  ball_.p = ball_.p + kDt * ball_.v;
}

void ToyGame::rollBall(const std::vector<std::array<Pose, 2>>& soles_before) {
  slideAndRoll();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Pose X_FR = toPose(robots_[i]->puppet.pose());
    for (std::size_t side = 0; side < 2; ++side) {
      const Pose X_FS = X_FR * robots_[i]->puppet.posture().X_RF[side];
      if (X_FS.translation.z > 0.1) continue;
      const Vector3 p_S = applyInverse(X_FS, Vector3{ball_.p.x, ball_.p.y, X_FS.translation.z});
      const Vector3 nearest{clamp(p_S.x, -0.5 * kSoleLength, 0.5 * kSoleLength),
                            clamp(p_S.y, -0.5 * kSoleWidth, 0.5 * kSoleWidth), 0};
      const Vector3 out = X_FS.rotation * (p_S - nearest);
      const double distance = sqrt(out.x * out.x + out.y * out.y);
      if (distance >= kBallRadius || distance < 1e-6) continue;
      const Vector3 v = (X_FS * nearest - soles_before[i][side] * nearest) * (1 / kDt);
      touch(ball_.p, {out.x / distance, out.y / distance}, kBallRadius - distance, {v.x, v.y});
    }
  }
}

void ToyGame::referee() {
  const client::FieldDescription field = makeRobot().field;
  const double x = 0.5 * field.length, y = 0.5 * field.width;
  if (std::fabs(ball_.p.x) > x) {
    if (std::fabs(ball_.p.y) < 0.5 * field.goal_width) {
      const int scorer = ball_.p.x > 0 ? 0 : 1;
      ++score_[static_cast<std::size_t>(scorer)];
      return kickOff(1 - scorer);
    }
    placeBall({ball_.p.x > 0 ? x - 0.5 : -x + 0.5, ball_.p.y > 0 ? y - 0.5 : -y + 0.5});
  } else if (std::fabs(ball_.p.y) > y) {
    placeBall({ball_.p.x, ball_.p.y > 0 ? y - 0.2 : -y + 0.2});
  }
}

void ToyGame::kickOff(int team) {
  kickoff_team_ = team;
  wait_ = 2;
  placeBall({0, 0});
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    PlanarPose start = starts_[i];
    const bool close = norm(Point{start.x, start.y}) < 0.8;
    if (close && robots_[i]->entry.team != team) start.x -= 0.55;
    robots_[i]->puppet.place(turnedField(start, robots_[i]->entry.team));
    robots_[i]->placed = true;
  }
}

}  // namespace murosimf::controllers
