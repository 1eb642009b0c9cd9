#pragma once

/// @file Where in the field of view a shape lies: the smallest rectangle of slopes x / z, y / z that holds it.
///
/// Independent of the lens, since a lens only says which slopes a pixel has.

#include "murosimf/algorithms/shape.h"

namespace murosimf {

struct SlopeRectangle {
  float x_low, x_high, y_low, y_high;
  bool isEmpty() const { return x_low > x_high; }
};

/// Rectangle of a shape whose pose in camera frame C is X_CS; empty when all of it lies behind the camera's plane.
/// A thousandth wider than exact, so that no rounding of rays leaves it. Parts behind the camera's plane are cut off.
SlopeRectangle rectangleOf(const Shape& shape, const Pose& X_CS);

/// Rectangle of the flat ellipse of points middle + a first + b second, a^2 + b^2 <= 1.
SlopeRectangle rectangleOfEllipse(const Vector3& middle_C, const Vector3& first_C, const Vector3& second_C);

}  // namespace murosimf
