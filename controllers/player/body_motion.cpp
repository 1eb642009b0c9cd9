#include "body_motion.h"

#include <algorithm>

namespace murosimf::controllers {

namespace {
JointAngles walkReady() { return walkingPose({}, 0, 0, {}); }
}  // namespace

JointAngles anglesOf(std::span<const client::JointReading> joints) {
  JointAngles q{};
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = joints[i].position;
  return q;
}

BodyMotion::BodyMotion()
    : kick_({kickFrames(kRight, walkReady()), kickFrames(kLeft, walkReady())}),
      recovery_(walkReady()),
      commanded_(walkReady()) {}

bool BodyMotion::startsKick(const MotionRequest& wish) {
  if (wish.kind != MotionRequest::Kind::kKick || !settled()) return false;
  kick_.start(wish.foot, commanded_);
  ++kicks_started_;
  settled_time_ = 0, recovery_time_ = kRecoveryTime;
  return true;
}

JointAngles BodyMotion::recover(double dt) {
  if (!recovery_.active()) {
    kick_.stop();
    engine_.halt();
    recovery_.begin(commanded_);
  }
  settled_time_ = 0, recovery_time_ = kRecoveryTime;
  return recovery_.step(dt, fall_);
}

void BodyMotion::startFrom(const JointAngles& q) {
  first_ = q;
  start_time_ = 0;
}

JointAngles BodyMotion::getReady(double dt) {
  start_time_ += dt;
  const double t = std::min(1.0, start_time_ / kStartTime), share = t * t * (3 - 2 * t);
  JointAngles angles = walkReady();
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = first_[i] + share * (angles[i] - first_[i]);
  return angles;
}

void BodyMotion::putUpright() {
  if (recovery_.active()) recovery_.begin(commanded_);
}

JointAngles BodyMotion::step(double dt, const MotionRequest& wish, const BodySense& felt, bool feedback) {
  fall_.observe(dt, felt.specific_force);
  if (recovery_.active() || fall_.lies()) return commanded_ = recover(dt);
  if (start_time_ < kStartTime) return commanded_ = getReady(dt);
  if (kick_.running() || startsKick(wish)) {
    const int foot = kick_.motion();
    commanded_ = kick_.step(dt);
    if (feedback) addKickFeedback(foot, felt.angular_velocity, commanded_);
    return commanded_;
  }
  recovery_time_ = std::max(0.0, recovery_time_ - dt);
  const bool walks = wish.kind == MotionRequest::Kind::kWalk && recovery_time_ <= 0;
  walks ? engine_.walk(wish.walk) : engine_.stop();
  commanded_ = engine_.step(dt, felt.angular_velocity, feedback);
  settled_time_ = engine_.standing() ? settled_time_ + dt : 0.0;
  return commanded_;
}

void BodyMotion::archive(client::StateArchive& archive) {
  archive(engine_, kick_, fall_, recovery_, commanded_, first_, start_time_, settled_time_, recovery_time_,
          kicks_started_);
}

}  // namespace murosimf::controllers
