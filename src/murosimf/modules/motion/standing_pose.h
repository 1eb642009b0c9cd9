#pragma once

/// @file Where the base of a robot is that somebody puts on the ground with given joint positions.
///
/// A robot with soles stands flat on the sole below which no corner of another one lies, the last one of several such;
/// one without soles has its base upright and touches the ground with its lowest shape. The base has the given x, y and
/// heading.

#include <span>
#include <vector>

#include "murosimf/algorithms/tree_rows.h"
#include "murosimf/world/vocabulary.h"
#include "murosimf/world/world.h"

namespace murosimf {

class StandingPose {
 public:
  /// @param robot  needs tree; soles and shapes where it has them
  StandingPose(const World& world, ObjectId robot);
  int joints() const { return static_cast<int>(rows_.size()) - 1; }
  /// X_WB. q in the order of the tree's rows behind the base. Allocates nothing.
  Pose find(std::span<const double> q, const PlanarPose& place);

 private:
  Pose flatOnSole() const;
  Pose onLowestShape() const;

  std::vector<Pose> X_BR_;  // of every row, as last found
  std::vector<KernelRow> rows_;
  std::vector<SolePlace> soles_;
  std::vector<PlacedShape> shapes_;
};

}  // namespace murosimf
