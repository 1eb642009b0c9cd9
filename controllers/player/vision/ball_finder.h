#pragma once

/// @file Finds the ball: an orange disc whose outline is that of a sphere of known radius lying on the ground.
///
/// A sphere of radius r at distance D is seen inside a cone of half-angle alpha, sin alpha = r / D. All unit rays e to
/// its outline satisfy e . n = 1 with n = c / cos alpha (c: unit vector to the centre): three linear equations, exact
/// through any lens and from any part of the outline, so a ball that is partly covered or cut by the border of the
/// picture is measured as well. n is found by least squares with outliers left out.
///
/// Distance: by the ray c meeting the plane z = r, deviation (d^2 + h^2) / h times the error of the inclination; by
/// size, D times the relative error of alpha. Both are weighed by their variances; when they contradict each other,
/// it is no ball.

#include "player/percepts.h"
#include "player/vision/colour_grid.h"

namespace murosimf::controllers {

/// Adds the balls of one picture to out.balls and out.drawn, largest region first. Cost: some 20 microseconds a
/// candidate.
void findBalls(const PictureView& view, const ColourGrid& grid, double ball_radius, Percepts& out);

}  // namespace murosimf::controllers
