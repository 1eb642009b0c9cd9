#include "head_motion.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

namespace {

constexpr double kLargestSpeed = 3.0;  // [rad/s]
constexpr double kGain = 10.0;         // of following [1/s]
constexpr double kPanRange = degrees(90), kTiltUpRange = degrees(-45), kTiltDownRange = degrees(60);
constexpr double kTimeBetweenGlances = 1.6, kGlanceTime = 0.7;  // [s], the latter with the way there

// Far sweep at a tilt that has the horizon in the picture, near sweep that has the own feet in it.
constexpr HeadAngles kSearchSweep[] = {
    {degrees(70), degrees(10)}, {degrees(-70), degrees(10)}, {degrees(-60), degrees(45)}, {degrees(60), degrees(45)}};
constexpr HeadAngles kFieldSweep[] = {{degrees(75), degrees(4)}, {degrees(-75), degrees(4)}};

double follow(double now, double target, double dt) {
  const double step = (target - now) * std::min(1.0, kGain * dt);
  return now + clamp(step, -kLargestSpeed * dt, kLargestSpeed * dt);
}

/// Evenly, so that every part of a sweep gets equally many pictures.
double sweepTo(double now, double target, double dt) {
  return now + clamp(target - now, -kLargestSpeed * dt, kLargestSpeed * dt);
}

}  // namespace

HeadAngles lookAt(const Posture& posture, const Vector3& p_R) {
  const Vector3 p_P = applyInverse(posture.X_RP, p_R);
  const Vector3 from_pan = p_P - Vector3{0, 0, kWaistHeight + kNeckHeight};
  const double r = sqrt(from_pan.x * from_pan.x + from_pan.y * from_pan.y) - kTiltForward;
  const double z = from_pan.z - kTiltUp;
  const double distance = std::max(0.05, sqrt(r * r + z * z));
  const double tilt = atan2(-z, r) + asin(kEyeUp / distance);
  return {clamp(atan2(from_pan.y, from_pan.x), -kPanRange, kPanRange), clamp(tilt, kTiltUpRange, kTiltDownRange)};
}

HeadAngles HeadMotion::searchTarget(const HeadRequest& request) {
  const bool near_too = request.kind == HeadRequest::Kind::kSearch;
  const std::size_t corners = near_too ? std::size(kSearchSweep) : std::size(kFieldSweep);
  const HeadAngles* sweep = near_too ? kSearchSweep : kFieldSweep;
  sweep_ %= corners;
  const HeadAngles goal = sweep[sweep_];
  const bool arrived = std::fabs(goal.pan - commanded_.pan) + std::fabs(goal.tilt - commanded_.tilt) < 1e-6;
  if (arrived) sweep_ = (sweep_ + 1) % corners;
  return sweep[sweep_];
}

HeadAngles HeadMotion::watchTarget(double dt, const HeadRequest& request, const Posture& posture) {
  const bool may_glance = request.kind == HeadRequest::Kind::kBallAndField && request.has_landmark;
  glance_left_ = may_glance ? glance_left_ - dt : 0.0;
  if (glance_left_ > 0) return lookAt(posture, request.landmark);
  glance_left_ = 0;
  watched_ += dt;
  if (may_glance && watched_ > kTimeBetweenGlances) glance_left_ = kGlanceTime, watched_ = 0;
  return lookAt(posture, request.ball);
}

HeadAngles HeadMotion::step(double dt, const HeadRequest& request, const Posture& posture) {
  const bool ahead = request.kind == HeadRequest::Kind::kAhead;
  const bool sweeps = request.kind == HeadRequest::Kind::kSearch || request.kind == HeadRequest::Kind::kLookAround;
  if (sweeps || ahead) {
    glance_left_ = 0;
    const HeadAngles goal = ahead ? HeadAngles{} : searchTarget(request);
    commanded_ = {sweepTo(commanded_.pan, goal.pan, dt), sweepTo(commanded_.tilt, goal.tilt, dt)};
  } else {
    const HeadAngles goal = watchTarget(dt, request, posture);
    commanded_ = {follow(commanded_.pan, goal.pan, dt), follow(commanded_.tilt, goal.tilt, dt)};
  }
  return commanded_;
}

void HeadMotion::archive(client::StateArchive& archive) { archive(commanded_, sweep_, watched_, glance_left_); }

}  // namespace murosimf::controllers
