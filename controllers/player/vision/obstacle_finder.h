#pragma once

/// @file Finds red obstacles that stand on the ground, as those of a slalom or an obstacle run do.
///
/// Each column of a red region has its foot where the red ends on carpet. Where feet of neighbouring columns are rows
/// apart, one obstacle ends and another one behind it begins, or it is its side that leans. The middle of an obstacle
/// is behind the middle of its feet by most of its radius. What is cut off by the picture's lower border is left out.

#include "player/percepts.h"
#include "player/vision/colour_grid.h"

namespace murosimf::controllers {

/// Adds the obstacles of one picture. @param radius  no part of one is farther from its middle [m]
void findObstacles(const PictureView& view, const ColourGrid& grid, double radius, Percepts& out);

}  // namespace murosimf::controllers
