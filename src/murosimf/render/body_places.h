#pragma once

/// @file Where the bodies of an object are: a robot's, a free body's, or those of something that never moves.

#include "murosimf/linking/body_path.h"
#include "murosimf/render/property_renderer.h"

namespace murosimf {

class BodyPlaces {
 public:
  explicit BodyPlaces(const RenderedObject& object);
  /// Rows of bodies; 1 for all but robots.
  int rows() const { return rows_; }
  /// X_WB of the body on a row at the end of a frame.
  Pose pose(int row, long frame) const;

 private:
  BodyPath path_;      // of a robot
  Handle<Pose> base_;  // of a free body
  Pose fixed_;
  int rows_ = 1;
};

}  // namespace murosimf
