#include "murosimf/modules/camera/sight_distorter.h"

#include <algorithm>

#include "murosimf/modules/camera/random_events.h"

namespace murosimf {

namespace {

enum Purpose : std::uint64_t { kMiss, kBearing, kDistance, kOutage, kCount, kPlace };
constexpr std::uint64_t kNumbersAPicture = 512;    // of false percepts: 64 of them, some numbers each
constexpr double kNearest = 0.3, kHalfLine = 0.5;  // of false percepts [m]

std::uint64_t streamOf(Purpose purpose, std::size_t of) { return static_cast<std::uint64_t>(of) * 8 + purpose; }

/// The point turned about the vertical through the camera, its horizontal distance stretched; in C.
Vector3 shifted(const Pose& X_WC, const Vector3& p_W, double turn, double stretch) {
  const Vector3 way = p_W - X_WC.translation;
  const SinCos<double> sc = sincos(turn);
  const Vector3 told{stretch * (sc.cos * way.x - sc.sin * way.y), stretch * (sc.sin * way.x + sc.cos * way.y), way.z};
  return applyTransposed(X_WC.rotation, told);
}

}  // namespace

SightDistorter::SightDistorter(const OracleEye& eye, const ErrorsByKind& errors, std::uint64_t seed,
                               std::string_view camera, double period)
    : errors_(errors), period_(period), valid_radius_(validRadius(eye.camera())) {
  const auto stream = [&](Purpose purpose, std::size_t of) {
    return RandomStream(seed, camera, streamOf(purpose, of));
  };
  for (std::size_t i = 0; i < eye.targets().size(); ++i) {
    things_.push_back({stream(kMiss, i), stream(kBearing, i), stream(kDistance, i)});
    members_[kindIndex(eye.targets()[i].kind)].push_back(static_cast<int>(i));
  }
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    kinds_[k] = {stream(kOutage, k), stream(kCount, k), stream(kPlace, k)};
  }
}

void SightDistorter::distort(const OracleEye& eye, std::span<const TrueSight> seen, const LookMoment& moment,
                             SightingsByKind& told) const {
  std::array<bool, kSightKinds> blind{};
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    told[k].clear();
    blind[k] = isOutage(kinds_[k].outage, moment.time, errors_[k].outage_rate, errors_[k].outage_length);
  }
  for (const TrueSight& sight : seen) {
    const SightKind kind = eye.targets()[static_cast<std::size_t>(sight.target)].kind;
    if (!blind[kindIndex(kind)]) addSight(sight, kind, moment, told);
  }
  for (std::size_t k = 0; k < kSightKinds; ++k) {
    if (!blind[k]) addFalse(eye, static_cast<SightKind>(k), moment, told);
  }
}

void SightDistorter::addSight(const TrueSight& sight, SightKind kind, const LookMoment& moment,
                              SightingsByKind& told) const {
  const SightErrors& e = errors_[kindIndex(kind)];
  const ThingStreams& random = things_[static_cast<std::size_t>(sight.target)];
  if (random.miss.uniform(moment.number) < e.miss) return;
  constexpr double kLeastStretch = 0.05;
  const double turn = e.bearing_bias + e.bearing_noise * random.bearing.normal(moment.number);
  const double stretch = 1 + e.distance_bias + e.distance_noise * random.distance.normal(moment.number);
  const auto place = [&](const Vector3& p_W) {
    return shifted(moment.X_WC, p_W, turn, std::max(stretch, kLeastStretch));
  };
  told[kindIndex(kind)].push_back({sight.target, place(sight.p_W), place(sight.q_W)});
}

void SightDistorter::addFalse(const OracleEye& eye, SightKind kind, const LookMoment& moment,
                              SightingsByKind& told) const {
  const SightErrors& e = errors_[kindIndex(kind)];
  const KindStreams& random = kinds_[kindIndex(kind)];
  const std::vector<int>& members = members_[kindIndex(kind)];
  if (members.empty() || !(e.false_rate > 0)) return;
  const int count = poissonCount(random.count.uniform(moment.number), e.false_rate * period_);
  for (int i = 0; i < count; ++i) {
    std::uint64_t step = moment.number * kNumbersAPicture + static_cast<std::uint64_t>(i) * 8;
    const auto even = [&](double low, double high) { return random.place.uniform(step++, low, high); };
    const CameraModel& camera = eye.camera();
    const double u = even(-0.5, camera.width - 0.5), v = even(-0.5, camera.height - 0.5);
    const double distance = even(std::min(kNearest, e.range), e.range), direction = even(0, kPi);
    const auto member = static_cast<std::size_t>(even(0, 1) * static_cast<double>(members.size()));
    const int taken_for = members[member];
    const OracleTarget& like = eye.targets()[static_cast<std::size_t>(taken_for)];
    const RaySlopes ray = unproject(camera, {u, v}, valid_radius_);
    const Vector3 ray_W = moment.X_WC.rotation * Vector3{ray.x, ray.y, 1};
    const SinCos<double> bearing = sincos(atan2(ray_W.y, ray_W.x)), along = sincos(direction);
    const Vector3 p_W{moment.X_WC.translation.x + distance * bearing.cos,
                      moment.X_WC.translation.y + distance * bearing.sin, like.height};
    const Vector3 half =
        kind == SightKind::kLine ? Vector3{kHalfLine * along.cos, kHalfLine * along.sin, 0} : Vector3{};
    told[kindIndex(kind)].push_back(
        {taken_for, applyInverse(moment.X_WC, p_W - half), applyInverse(moment.X_WC, p_W + half)});
  }
}

}  // namespace murosimf
