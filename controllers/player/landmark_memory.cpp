#include "landmark_memory.h"

#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr int kLongestAge = 600;        // moves after which a sight is forgotten: 6 s
constexpr double kDriftPerWay = 0.01;   // variance of the odometry [m^2/m]
constexpr double kDriftPerTurn = 0.01;  // [rad^2/rad], as seen from the landmark's distance
constexpr double kSamePlace = 0.6;      // sights of one kind and colour nearer than this are the same landmark [m]
constexpr double kBeyondField = 0.7;    // a robot may stand this far outside the lines [m]
constexpr double kLineHeading = 0.15;   // deviation of a heading that lines tell [rad]
constexpr double kFitDeviation = 0.5;   // of the rigid fit before the corrections [m], [rad]

Point seenAt(const LandmarkSight& sight) {
  const SinCos<double> bearing = sincos(sight.bearing);
  return {sight.distance * bearing.cos, sight.distance * bearing.sin};
}

/// The pose that puts a and b onto A and B, exactly in direction and in their middle.
PlanarPose rigidFit(const Point& a_R, const Point& b_R, const Point& A_F, const Point& B_F) {
  const double heading = wrapAngle(direction(B_F - A_F) - direction(b_R - a_R));
  const Point middle = 0.5 * (A_F + B_F) - turned(sincos(heading), 0.5 * (a_R + b_R));
  return {middle.x, middle.y, heading};
}

PoseBelief refined(PlanarPose pose, const LandmarkSight& a, const LandmarkSight& b, const Point& A, const Point& B) {
  PoseBelief belief;
  for (int round = 0; round < 2; ++round) {
    belief = PoseBelief::at(pose, kFitDeviation, kFitDeviation);
    belief.correct(belief.compare(a, A));
    belief.correct(belief.compare(b, B));
    pose = belief.mean;
  }
  return belief;
}

}  // namespace

void LandmarkMemory::move(const PlanarPose& increment) {
  const double way = norm(Point{increment.x, increment.y}), turn = std::fabs(increment.heading);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Entry entry = entries_[i];
    if (++entry.age > kLongestAge) continue;
    entry.p_R = transformedBack(increment, entry.p_R);
    entry.drift += kDriftPerWay * way + kDriftPerTurn * turn;
    entries_[kept++] = entry;
  }
  count_ = kept;
}

void LandmarkMemory::add(const LandmarkSight& sight) {
  const Point p_R = seenAt(sight);
  const std::size_t place = placeFor(sight, p_R);
  if (place == count_) ++count_;
  entries_[place] = {sight, p_R, 0, 0};
}

std::size_t LandmarkMemory::placeFor(const LandmarkSight& sight, const Point& p_R) const {
  std::size_t oldest = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Entry& entry = entries_[i];
    const bool alike = entry.sight.kind == sight.kind && entry.sight.colour == sight.colour;
    if (alike && norm(entry.p_R - p_R) < kSamePlace) return i;
    if (entry.age > entries_[oldest].age) oldest = i;
  }
  return count_ < kCapacity ? count_ : oldest;
}

LandmarkSight LandmarkMemory::sight(std::size_t i) const {
  const Entry& entry = entries_[i];
  LandmarkSight result = entry.sight;
  result.bearing = direction(entry.p_R);
  result.distance = norm(entry.p_R);
  result.distance_variance += entry.drift;
  result.bearing_variance += entry.drift / (0.04 + result.distance * result.distance);
  return result;
}

void LandmarkMemory::archive(client::StateArchive& archive) {
  for (Entry& entry : entries_) archive(entry);
  archive(count_);
}

PoseProposals posesFromPair(const FieldMap& map, const LandmarkSight& a, const LandmarkSight& b) {
  PoseProposals proposals;
  const Point a_R = seenAt(a), b_R = seenAt(b);
  const double apart = norm(a_R - b_R);
  const double tolerance = 0.1 + 3 * sqrt(a.distance_variance + b.distance_variance);
  if (apart < 0.3) return proposals;
  for (const Point& A : map.landmarks(a.kind, a.colour))
    for (const Point& B : map.landmarks(b.kind, b.colour)) {
      const double painted = norm(A - B);
      if (painted < 0.3 || std::fabs(painted - apart) > tolerance) continue;
      const PoseBelief belief = refined(rigidFit(a_R, b_R, A, B), a, b, A, B);
      if (map.contains({belief.mean.x, belief.mean.y}, kBeyondField)) proposals.beliefs[proposals.count++] = belief;
    }
  return proposals;
}

PoseProposals posesFromOne(const FieldMap& map, const LandmarkSight& sight, double line_direction) {
  PoseProposals proposals;
  const Point p_R = seenAt(sight);
  for (const Point& p_F : map.landmarks(sight.kind, sight.colour))
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double heading = wrapAngle(0.5 * kPi * quarter - line_direction);
      const Point place = p_F - turned(sincos(heading), p_R);
      if (!map.contains(place, kBeyondField)) continue;
      const double deviation = sqrt(sight.distance_variance + kLineHeading * kLineHeading * dot(p_R, p_R));
      proposals.beliefs[proposals.count++] = PoseBelief::at({place.x, place.y, heading}, deviation, kLineHeading);
    }
  return proposals;
}

}  // namespace murosimf::controllers
