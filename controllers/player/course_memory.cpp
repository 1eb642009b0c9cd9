#include "course_memory.h"

#include <algorithm>

namespace murosimf::controllers {

namespace {
constexpr int kBelieved = 3;        // sightings
constexpr double kUsualSame = 0.3;  // [m]
constexpr double kFarthest = 2.2;   // farther ones are not well measured [m]
constexpr double kClose = 0.6;      // here a sighting counts half [m]
}  // namespace

void CourseMemory::start(const client::CourseDescription& course) {
  const double apart = course.obstacle_spacing;
  same_ = apart > 0 ? std::min(std::max(kUsualSame, 0.6 * apart), 0.9 * apart) : kUsualSame;
}

void CourseMemory::move(const PlanarPose& increment) {
  for (Known& obstacle : known_) obstacle.p_R = transformedBack(increment, obstacle.p_R);
  collectPlaces();
}

void CourseMemory::observe(std::span<const ObstaclePercept> obstacles) {
  for (const ObstaclePercept& seen : obstacles) {
    const Point p{seen.x, seen.y};
    const double distance = norm(p);
    if (!(distance < kFarthest)) continue;
    const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const Known& a, const Known& b) {
      return norm(a.p_R - p) < norm(b.p_R - p);
    });
    if (nearest != known_.end() && norm(nearest->p_R - p) < same_) {
      const double weight = std::max(kClose / (kClose + distance) * 0.4, 1.0 / (nearest->seen + 1));
      nearest->p_R = nearest->p_R + weight * (p - nearest->p_R);
      ++nearest->seen;
    } else if (known_.size() < kLargestCount) {
      known_.push_back({p, 1});
    }
  }
  joinNeighbours();
  collectPlaces();
}

void CourseMemory::joinNeighbours() {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    for (std::size_t k = known_.size() - 1; k > i; --k) {
      Known &a = known_[i], &b = known_[k];
      if (!(norm(a.p_R - b.p_R) < same_)) continue;
      a.p_R = a.p_R + (static_cast<double>(b.seen) / (a.seen + b.seen)) * (b.p_R - a.p_R);
      a.seen += b.seen;
      known_.erase(known_.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
}

void CourseMemory::collectPlaces() {
  places_.clear();
  for (const Known& obstacle : known_) {
    if (obstacle.seen >= kBelieved) places_.push_back(obstacle.p_R);
  }
}

}  // namespace murosimf::controllers
