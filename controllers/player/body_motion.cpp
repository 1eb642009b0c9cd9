#include "body_motion.h"

#include <algorithm>

namespace murosimf::controllers {

namespace {
JointAngles walkReady() { return walkingPose({}, 0, 0, {}); }
}  // namespace

BodyMotion::BodyMotion()
    : kick_({kickFrames(kRight, walkReady()), kickFrames(kLeft, walkReady())}), commanded_(walkReady()) {}

bool BodyMotion::startsKick(const MotionRequest& wish) {
  if (wish.kind != MotionRequest::Kind::kKick || !settled()) return false;
  kick_.start(wish.foot, commanded_);
  ++kicks_started_;
  settled_time_ = 0, recovery_time_ = kRecoveryTime;
  return true;
}

JointAngles BodyMotion::step(double dt, const MotionRequest& wish, const Vector3& angular_velocity, bool feedback) {
  if (kick_.running() || startsKick(wish)) {
    const int foot = kick_.motion();
    commanded_ = kick_.step(dt);
    if (feedback) addKickFeedback(foot, angular_velocity, commanded_);
    return commanded_;
  }
  recovery_time_ = std::max(0.0, recovery_time_ - dt);
  const bool walks = wish.kind == MotionRequest::Kind::kWalk && recovery_time_ <= 0;
  walks ? engine_.walk(wish.walk) : engine_.stop();
  commanded_ = engine_.step(dt, angular_velocity, feedback);
  settled_time_ = engine_.standing() ? settled_time_ + dt : 0.0;
  return commanded_;
}

void BodyMotion::archive(client::StateArchive& archive) {
  archive(engine_, kick_, commanded_, settled_time_, recovery_time_, kicks_started_);
}

}  // namespace murosimf::controllers
