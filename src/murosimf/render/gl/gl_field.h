#pragma once

/// @file The painted ground on the graphics card: where which lines may be seen.
///
/// The field is cut into cells; each knows the lines and circles that come near it, so that most pixels look at none.
/// A pixel whose footprint on the ground is larger than what the cells allow for looks at all.

#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/render/gl/field_tiles.h"
#include "murosimf/render/gl/gl_object.h"
#include "murosimf/render/gl/gl_program.h"

namespace murosimf {

class GlField {
 public:
  /// @throws std::invalid_argument for a ground with a picture on it, which is not drawn
  explicit GlField(const PaintedGround& ground);
  /// Gives the program in use all but colours; takes texture units 1 and 2.
  void set(const GlProgram& program, const Vector3& eye_W) const;
  /// For sortTiles().
  const MarkedCells& marked() const { return marked_; }

 private:
  PaintedGround ground_;
  std::array<float, 4> grid_{};
  MarkedCells marked_;
  GlBuffer values_;
  GlTexture marks_, cells_;
};

}  // namespace murosimf
