#include "line_sights.h"

#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr double kFarthest = 15;         // no field is seen farther [m]
constexpr double kIndependentLines = 3;  // as many points of one picture count fully: they share the camera's errors
constexpr double kOneDirection = 0.7;    // mean resultant length above which the lines agree on a direction

bool plausible(const LinePercept& percept) {
  const double squared = percept.x * percept.x + percept.y * percept.y;
  return squared > 1e-4 && squared < kFarthest * kFarthest && std::fabs(percept.normal) < 100;
}

/// Variance of a point across its line: its distance suffers from the camera's tilt, its direction does not.
double offsetVariance(const LineSights::Sight& sight) {
  const double d = sight.distance;
  const double along_ray = 0.03 + 0.02 * d + 0.01 * d * d, across_ray = 0.02 + 0.02 * d;
  const double cosine = (sight.p_R.x * sight.normal.cos + sight.p_R.y * sight.normal.sin) / d;
  const double share = cosine * cosine;
  return share * along_ray * along_ray + (1 - share) * across_ray * across_ray;
}

}  // namespace

LineSights::LineSights(const std::vector<LinePercept>& percepts) {
  const std::size_t stride = 1 + percepts.size() / kCapacity;
  for (std::size_t i = 0; i < percepts.size() && count_ < kCapacity; i += stride) {
    if (!plausible(percepts[i])) continue;
    Sight& sight = sights_[count_++];
    sight.p_R = {percepts[i].x, percepts[i].y};
    sight.distance = norm(sight.p_R);
    sight.normal = sincos(percepts[i].normal);
    sight.variance = offsetVariance(sight);
  }
  const double share = static_cast<double>(count_) / kIndependentLines;
  if (share > 1) dependence_ = share;
  for (Sight& sight : std::span(sights_).first(count_)) sight.variance *= dependence_;
  findDirection();
}

/// The mean of four times the angle does not know right angles apart.
void LineSights::findDirection() {
  Point sum{};
  for (const Sight& sight : sights()) {
    const double c = sight.normal.cos, s = sight.normal.sin;
    const Point doubled{c * c - s * s, 2 * c * s};
    sum = sum + Point{doubled.x * doubled.x - doubled.y * doubled.y, 2 * doubled.x * doubled.y};
  }
  has_direction_ = count_ >= 4 && norm(sum) > kOneDirection * static_cast<double>(count_);
  direction_ = 0.25 * murosimf::controllers::direction(sum);
}

}  // namespace murosimf::controllers
