#pragma once

/// @file Finds goal posts and landmark poles among the upright bars, and measures them.
///
/// An upright cylinder of radius r whose axis is d away is seen between two vertical planes, the same at any height:
///   half-angle beta in azimuth, sin beta = r / d; the axis in the middle.
/// So the edges are measured in many rows, each turned into an azimuth in R, and the medians taken: lens, roll of the
/// camera and a few covered rows do no harm. The foot point, where carpet begins below, gives d - r by the ground
/// plane. Both distances are weighed by their variances; a foot that contradicts the width is not believed.
///
/// A post is one colour, much higher than wide; a pole a stack of squares of changing colours, whose joints are
/// .20 and .40 m (one and two thirds of the height) above the ground.

#include "player/percepts.h"
#include "player/vision/bars.h"

namespace murosimf::controllers {

class LandmarkFinder {
 public:
  /// Reserves memory.
  void start() { chainer_.start(ColourGrid::kMostRuns); }
  /// Adds the posts and poles of one picture. Cost: some 10 microseconds a bar.
  void find(const PictureView& view, const ColourGrid& grid, const client::FieldDescription& field, Percepts& out);

 private:
  BarChainer chainer_;
};

}  // namespace murosimf::controllers
