#pragma once

/// @file Robots seen in pictures, for a few seconds, carried along as the own robot moves.

#include <span>
#include <vector>

#include "murosimf/control/client/state_archive.h"
#include "percepts.h"
#include "plane.h"

namespace murosimf::controllers {

/// Sightings closer than .3 m are one robot. No allocation after construction.
class ObstacleMemory {
 public:
  ObstacleMemory() { seen_.reserve(kLargestCount), places_.reserve(kLargestCount); }
  /// @param increment  pose of the new R in the old R
  void move(const PlanarPose& increment, double dt);
  void observe(std::span<const RobotPercept> robots);
  /// Where they were seen, in R [m].
  std::span<const Point> places_R() const { return places_; }
  void clear() { seen_.clear(), places_.clear(); }
  void archive(client::StateArchive& archive) { archive(seen_, places_); }

 private:
  static constexpr std::size_t kLargestCount = 12;
  struct Sighting {
    Point p_R;
    double age = 0;  ///< [s]
  };
  void collectPlaces();

  std::vector<Sighting> seen_;
  std::vector<Point> places_;
};

}  // namespace murosimf::controllers
