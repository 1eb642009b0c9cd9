#include "fall_detector.h"

#include <cmath>

#include "ks21.h"

namespace murosimf::controllers {

namespace {

constexpr double kGravity = 9.81;
constexpr double kRange = 4 * kGravity, kFaint = kGravity / 3;  // [m/s^2]
constexpr double kShare = 0.3;                                  // of a new reading in the smoothed one
constexpr double kLyingTilt = degrees(45), kLyingTime = 0.3;
constexpr double kUprightTilt = degrees(25), kUprightTime = 0.7;

double cut(double x) { return clamp(x, -kRange, kRange); }

}  // namespace

void FallDetector::observe(double dt, const Vector3& specific_force) {
  const Vector3 reading{cut(specific_force.x), cut(specific_force.y), cut(specific_force.z)};
  smoothed_ = reading * kShare + smoothed_ * (1 - kShare);
  const Vector3& f = smoothed_;
  const bool tells = norm(f) > kFaint;
  const double tilt = atan2(sqrt(f.x * f.x + f.y * f.y), f.z);
  tilted_time_ = tells && tilt > kLyingTilt ? tilted_time_ + dt : 0.0;
  upright_time_ = tells && tilt < kUprightTilt ? upright_time_ + dt : 0.0;
}

bool FallDetector::lies() const { return tilted_time_ >= kLyingTime; }
bool FallDetector::upright() const { return upright_time_ >= kUprightTime; }

LyingSide FallDetector::side() const {
  if (std::fabs(smoothed_.y) > std::fabs(smoothed_.x)) return LyingSide::kFlank;
  return smoothed_.x < 0 ? LyingSide::kFront : LyingSide::kBack;
}

}  // namespace murosimf::controllers
