#pragma once

/// @file Where obstacles stand that do not move: remembered as long as the attempt lasts, carried along as the own
/// robot moves.

#include <span>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/state_archive.h"
#include "percepts.h"
#include "plane.h"

namespace murosimf::controllers {

/// Sightings near a known obstacle move it; the nearer they are, the more. Obstacles that have moved towards one
/// another become one. No allocation after construction.
class CourseMemory {
 public:
  CourseMemory() { known_.reserve(kLargestCount), places_.reserve(kLargestCount); }
  void start(const client::CourseDescription& course);
  /// @param increment  pose of the new R in the old R
  void move(const PlanarPose& increment);
  void observe(std::span<const ObstaclePercept> obstacles);
  /// Those seen often enough to be believed, in R [m].
  std::span<const Point> places_R() const { return places_; }
  void clear() { known_.clear(), places_.clear(); }
  void archive(client::StateArchive& archive) { archive(known_, places_); }

 private:
  static constexpr std::size_t kLargestCount = 32;
  struct Known {
    Point p_R;
    int seen = 0;
  };
  void joinNeighbours();
  void collectPlaces();

  double same_ = 0.3;  ///< sightings nearer to one another are of one obstacle [m]
  std::vector<Known> known_;
  std::vector<Point> places_;
};

}  // namespace murosimf::controllers
