#pragma once

/// @file A camera's lens on the graphics card: the rays of its pixels as a texture, its equations for shaders.
///
/// Corners of meshes go through the lens equations in homogeneous form. For a point p_C = (X, Y, Z), with R^2 = X^2 +
/// Y^2 and r = R / Z, what the shader computes is Z times the distorted slopes. From r = a on, every part goes on along
/// its tangent in r (lens_curve.h), which times Z is linear in R and Z:
///   Z C(r) -> (C(a) - C'(a) a) Z + C'(a) R,   Z r^2 -> a (2 R - a Z),   Z P(r) -> (P(a) - P'(a) a) Z + P'(a) R.
/// That is finite and steady behind the camera too, and never folds over, so triangles that reach there are clipped
/// like any other. a is the slope of the picture's widest ray, or of where the lens itself goes on linearly if that is
/// less: within the picture nothing is changed.

#include "murosimf/algorithms/ray_table.h"
#include "murosimf/render/gl/gl_object.h"
#include "murosimf/render/gl/gl_program.h"

namespace murosimf {

class GlLens {
 public:
  /// The context must be current; `rays` must outlive this. Cost: 8 bytes a pixel go to the card.
  explicit GlLens(const RayTable& rays);

  const CameraModel& camera() const { return table_.camera(); }
  const RayTable& table() const { return table_; }
  /// Slopes of the rays of all pixels, row 0 first.
  GLuint rays() const { return rays_.name(); }
  /// Gives the program in use the equations.
  void set(const GlProgram& program) const;
  /// Pixels that an angle of 1 rad covers at most.
  double density() const { return density_; }
  /// True where nothing of the sphere falls on the picture.
  bool misses(const Vector3& centre_C, double radius) const;

 private:
  const RayTable& table_;
  GlTexture rays_;
  SlopeRectangle seen_;
  double linear_from_ = 0, density_ = 0;
};

}  // namespace murosimf
