#include "player.h"

#include <cmath>
#include <stdexcept>

namespace murosimf::controllers {

namespace {

// How far a fall and the way back to the feet take the robot along each axis, and turn it: root mean squares over
// pushes of 3 and 5 N s in 32 directions.
constexpr double kFallDistance = 0.5, kFallTurn = 1.1;  // [m], [rad]

constexpr double kServoStiffness = 30, kKneeStiffness = 45;  // [N m/rad]

Role roleOf(const client::RobotDescription& robot) {
  if (robot.role.find("keeper") != std::string::npos) return Role::kKeeper;
  if (robot.role.find("defender") != std::string::npos) return Role::kDefender;
  if (robot.role.find("runner") != std::string::npos) return Role::kRunner;
  return Role::kStriker;
}

int wingOf(const client::RobotDescription& robot) {
  if (robot.role.find("left") != std::string::npos) return 1;
  return robot.role.find("right") != std::string::npos ? -1 : 0;
}

Point pointOf(const Vector3& p) { return {p.x, p.y}; }

void requireKs21(const client::RobotDescription& robot) {
  if (robot.joints.size() != kJointCount)
    throw std::invalid_argument("player: a KS21 with 21 joints is expected, '" + robot.model + "' has " +
                                std::to_string(robot.joints.size()));
  for (std::size_t i = 0; i < kJointNames.size(); ++i) {
    if (robot.joints[i].name != kJointNames[i])
      throw std::invalid_argument("player: joint " + std::to_string(i) + " of '" + robot.model + "' is '" +
                                  robot.joints[i].name + "', expected '" + std::string(kJointNames[i]) + "'");
  }
}

}  // namespace

void Player::start(const client::RobotDescription& robot) {
  requireKs21(robot);
  robot_ = robot;
  role_ = roleOf(robot), wing_ = wingOf(robot);
  obstacles_R_.reserve(64);
  course_.start(robot.course);
  eyes_->start(robot);
  localisation_.start(robot);
  ball_.start(robot);
  team_ball_.start(robot);
  behaviour_.start(robot);
}

void Player::step(const client::SensorFrame& sensors, client::CommandFrame& commands) {
  feelMotion(sensors);
  heedReferee(sensors.game, sensors.time);
  look(sensors);
  team_ball_.observe(sensors.team_messages, robot_.control_period, sensors.mate_poses, sensors.time);
  const Play play = behaviour_.step(gather(sensors), head_.glancing());
  moveJoints(sensors, play, commands);
  commands.message = message(play);
  fillReport(play);
}

void Player::feelMotion(const client::SensorFrame& sensors) {
  if (!posture_known_) body_.startFrom(anglesOf(sensors.joints));
  Posture now = computePosture(robot_, sensors.joints, posture_.stance);
  // While no sole is known to lie flat on the ground, the joints do not tell how the robot moves.
  const bool on_feet = posture_known_ && !body_.fallen();
  const PlanarPose increment = on_feet ? odometryIncrement(posture_, now) : PlanarPose{};
  posture_ = std::move(now), posture_known_ = true;
  past_.remember(sensors.time, increment, posture_);
  localisation_.move(increment);
  ball_.move(increment, robot_.control_period);
  obstacles_.move(increment, robot_.control_period);
  course_.move(increment);
  for (const client::JointReading& joint : sensors.joints) servos_feel_ = servos_feel_ || joint.torque != 0;
}

void Player::heedReferee(const client::GameInfo& game, double time) {
  const bool ball_moved = game.restart_count != restart_count_;
  restart_count_ = game.restart_count;
  if (game.placed) {
    localisation_.place(game.placed_at);
    obstacles_.clear();
    course_.clear();
    past_.forget();
    past_.remember(time, {}, posture_);
    body_.putUpright();
  }
  if (!game.placed && !ball_moved) return;
  ball_.forget();
  team_ball_.start(robot_);  // what mates said of the ball is no longer true
  behaviour_.restart();
}

void Player::expectLate(const client::SensorFrame& sensors) {
  for (const client::CameraPicture& picture : sensors.pictures) past_.expect(picture.time);
  for (const client::CameraSights& sights : sensors.sights) past_.expect(sights.time);
  if (sensors.own_pose.valid) past_.expect(sensors.own_pose.time);
}

void Player::look(const client::SensorFrame& sensors) {
  percepts_.clear();
  expectLate(sensors);
  const client::ToldPose& told = sensors.own_pose;
  if (told.valid) localisation_.place(compose(told.pose, past_.movedSince(told.time)));
  const bool sees = !sensors.pictures.empty() || !sensors.sights.empty();
  if (!sees || body_.fallen()) return;  // from the ground the posture explains no picture
  eyes_->process(sensors, past_, percepts_);
  localisation_.observe(percepts_);
  ball_.observe(percepts_);
  obstacles_.observe(percepts_.robots);
  course_.observe(percepts_.obstacles);
}

void Player::getBackOnFeet() {
  localisation_.widen(kFallDistance, kFallTurn);
  ball_.forget();
  obstacles_.clear();
  course_.clear();
}

/// @returns how many of obstacles_R_ are robots; these come first.
std::size_t Player::collectObstacles(const PlanarPose& X_FR) {
  const std::span<const Point> seen = obstacles_.places_R();
  obstacles_R_.assign(seen.begin(), seen.end());
  for (const Point& mate : team_ball_.mates()) obstacles_R_.push_back(transformedBack(X_FR, mate));
  const std::size_t robot_count = obstacles_R_.size();
  const double x = 0.5 * robot_.field.length, y = 0.5 * robot_.field.goal_width + robot_.field.post_radius;
  for (const Point& post : {Point{x, y}, Point{x, -y}, Point{-x, y}, Point{-x, -y}})
    obstacles_R_.push_back(transformedBack(X_FR, post));
  for (const Point& obstacle : course_.places_R()) obstacles_R_.push_back(obstacle);
  return robot_count;
}

Situation Player::gather(const client::SensorFrame& sensors) {
  Situation now;
  now.time = sensors.time, now.dt = robot_.control_period;
  now.game = sensors.game;
  now.role = role_, now.wing = wing_, now.number = robot_.number;
  now.X_FR = localisation_.pose();
  now.position_deviation = localisation_.positionDeviation();
  now.ball_known = ball_.known(), now.ball_age = ball_.age();
  now.ball_R = pointOf(ball_.position()), now.ball_velocity_R = pointOf(ball_.velocity());
  now.team_ball_known = team_ball_.known(), now.team_ball_age = team_ball_.age(),
  now.team_ball_F = team_ball_.position();
  now.mates = team_ball_.freshMessages();
  const std::size_t robot_count = collectObstacles(now.X_FR);
  now.obstacles_R = obstacles_R_;
  now.robots_R = now.obstacles_R.first(robot_count);
  now.course_R = course_.places_R();
  now.fallen = body_.fallen();
  now.settled = body_.settled(), now.kicking = body_.kicking(), now.kick_time = body_.kickTime();
  now.velocity = body_.velocity();
  return now;
}

void Player::moveJoints(const client::SensorFrame& sensors, const Play& play, client::CommandFrame& commands) {
  const double dt = robot_.control_period;
  // The gyroscope sits on the trunk, the legs hang on the pelvis.
  const Vector3 rate = rotationZ(sensors.joints[kWaistYaw].position) * sensors.angular_velocity;
  const bool was_fallen = body_.fallen();
  JointAngles angles = body_.step(dt, play.motion, {rate, sensors.specific_force}, servos_feel_);
  if (was_fallen && !body_.fallen()) getBackOnFeet();
  const HeadAngles head = head_.step(dt, play.head, posture_);
  angles[kHeadPan] = head.pan, angles[kHeadTilt] = head.tilt;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const client::JointDescription& joint = robot_.joints[i];
    const bool limited = joint.upper > joint.lower;
    const double position = limited ? clamp(angles[i], joint.lower, joint.upper) : angles[i];
    const bool knee = i == static_cast<std::size_t>(kFirstLegJoint[kRight] + kKnee) ||
                      i == static_cast<std::size_t>(kFirstLegJoint[kLeft] + kKnee);
    commands.joints[i] = {position, 0, 0, knee ? kKneeStiffness : kServoStiffness, 0};
  }
}

client::TeamMessage Player::message(const Play& play) const {
  const PlanarPose X_FR = localisation_.pose();
  const Point ball_F = transformed(X_FR, pointOf(ball_.position()));
  const double age = ball_.known() ? ball_.age() : 1e9;
  return {robot_.number, X_FR, ball_F.x, ball_F.y, age, play.cost_to_ball};
}

void Player::fillReport(const Play& play) {
  report_.percepts = percepts_.drawn;
  report_.pose = localisation_.pose();
  report_.pose_valid = localisation_.positionDeviation() < 0.5;
  report_.ball_known = ball_.known();
  report_.ball_x = ball_.position().x, report_.ball_y = ball_.position().y;
  report_.kicks_started = body_.kicksStarted();
  report_.activity = play.activity;
}

void Player::archive(client::StateArchive& archive) {
  archive(posture_.X_RP, posture_.X_RF, posture_.X_RC, posture_.stance, posture_known_, servos_feel_, restart_count_);
  eyes_->archive(archive);
  archive(past_, localisation_, ball_, team_ball_, obstacles_, course_, behaviour_, body_, head_);
}

std::unique_ptr<client::ControlSoftware> makePlayer() { return std::make_unique<Player>(makeEyes()); }

}  // namespace murosimf::controllers
