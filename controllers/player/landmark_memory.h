#pragma once

/// @file The landmarks seen during the last seconds, and the poses that two of them tell.
///
/// A head sees 60 degrees at once, so two landmarks are often seen one after the other. What was seen is moved along
/// by odometry; two remembered sights fix a pose, up to a few ways of naming the posts.

#include "murosimf/control/client/state_archive.h"
#include "pose_belief.h"

namespace murosimf::controllers {

class LandmarkMemory {
 public:
  static constexpr std::size_t kCapacity = 8;

  void clear() { count_ = 0; }
  void move(const PlanarPose& increment);
  /// Remembers a sight; replaces what looks like the same landmark at the same place, else the oldest when full.
  void add(const LandmarkSight& sight);
  std::size_t size() const { return count_; }
  /// The i-th sight as it would look from here, its variances grown by the way since.
  LandmarkSight sight(std::size_t i) const;
  void archive(client::StateArchive& archive);

 private:
  struct Entry {
    LandmarkSight sight;  ///< when it was seen
    Point p_R;            ///< where it is now
    double drift = 0;     ///< variance of the way since [m^2]
    int age = 0;          ///< moves since
    void archive(client::StateArchive& archive) { archive(sight, p_R, drift, age); }
  };
  std::size_t placeFor(const LandmarkSight& sight, const Point& p_R) const;

  std::array<Entry, kCapacity> entries_{};
  std::size_t count_ = 0;
};

/// The poses from which what was seen makes sense.
struct PoseProposals {
  std::array<PoseBelief, 8> beliefs;
  std::size_t count = 0;
};
/// Rigid fit of two points, then two rounds of correction by bearings and distances (Gauss-Newton). Poses far off the
/// field and pairs whose distance does not match the map are left out.
PoseProposals posesFromPair(const FieldMap& map, const LandmarkSight& a, const LandmarkSight& b);
/// One sight and the direction of the lines in R [rad]: lines run along x or y, which leaves four headings.
PoseProposals posesFromOne(const FieldMap& map, const LandmarkSight& sight, double line_direction);

}  // namespace murosimf::controllers
