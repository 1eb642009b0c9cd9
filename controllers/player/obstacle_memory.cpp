#include "obstacle_memory.h"

#include <algorithm>

namespace murosimf::controllers {

namespace {
constexpr double kLife = 5.0;       // of a sighting [s]
constexpr double kSameRobot = 0.3;  // [m]
constexpr double kFarthest = 2.5;   // farther ones are neither in the way nor well measured [m]
}  // namespace

void ObstacleMemory::move(const PlanarPose& increment, double dt) {
  for (Sighting& sighting : seen_) {
    sighting.p_R = transformedBack(increment, sighting.p_R);
    sighting.age += dt;
  }
  std::erase_if(seen_, [](const Sighting& sighting) { return sighting.age > kLife; });
  collectPlaces();
}

void ObstacleMemory::observe(std::span<const RobotPercept> robots) {
  for (const RobotPercept& robot : robots) {
    const Point p{robot.x, robot.y};
    if (!(norm(p) < kFarthest)) continue;
    const auto same =
        std::find_if(seen_.begin(), seen_.end(), [&](const Sighting& s) { return norm(s.p_R - p) < kSameRobot; });
    if (same != seen_.end()) {
      *same = {0.5 * (same->p_R + p), 0};
    } else if (seen_.size() < kLargestCount) {
      seen_.push_back({p, 0});
    }
  }
  collectPlaces();
}

void ObstacleMemory::collectPlaces() {
  places_.clear();
  for (const Sighting& sighting : seen_) places_.push_back(sighting.p_R);
}

}  // namespace murosimf::controllers
