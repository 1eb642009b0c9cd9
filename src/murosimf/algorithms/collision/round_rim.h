#pragma once

/// @file Eight points of a cylinder's rim that stand for its disc in a manifold.
///
/// They are fixed to the body, so that a standing cylinder rests on the same points from frame to frame; the one
/// nearest to a wanted direction is moved there, so that the deepest point of a tilted disc is exact.

#include "murosimf/math/vec3.h"

namespace murosimf {

inline constexpr int kRimPoints = 8;

/// Writes the unit vectors from the axis to the points, counterclockwise about z. `wanted`: a unit vector in the plane
/// of the disc, or zero for none. @return the number of the point that was moved, 0 for none
inline int placeOnRim(double wanted_x, double wanted_y, Vector3 (&direction)[kRimPoints]) {
  constexpr double kDiagonal = 0.70710678118654752440;
  constexpr Vector3 kFixed[kRimPoints] = {
      {1, 0, 0},  {kDiagonal, kDiagonal, 0},   {0, 1, 0},  {-kDiagonal, kDiagonal, 0},
      {-1, 0, 0}, {-kDiagonal, -kDiagonal, 0}, {0, -1, 0}, {kDiagonal, -kDiagonal, 0}};
  int nearest = 0;
  double most = 0;
  for (int i = 0; i < kRimPoints; ++i) {
    direction[i] = kFixed[i];
    const double along = kFixed[i].x * wanted_x + kFixed[i].y * wanted_y;
    if (along > most) most = along, nearest = i;
  }
  if (most > 0) direction[nearest] = {wanted_x, wanted_y, 0};
  return nearest;
}

}  // namespace murosimf
