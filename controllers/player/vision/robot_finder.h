#pragma once

/// @file Finds other robots: team marks, and below them the foot point where the carpet begins.
///
/// From every region of magenta or cyan the grid's columns are followed down over whatever is not carpet; the lowest
/// place reached is the foot. The mark must then hang at a height that robots have. Of several marks of one robot the
/// one with the nearest foot counts. A robot whose feet are out of the picture is left out.

#include "player/percepts.h"
#include "player/vision/colour_grid.h"

namespace murosimf::controllers {

/// Adds the robots of one picture; several marks of one robot give one percept.
void findRobots(const PictureView& view, const ColourGrid& grid, Percepts& out);

}  // namespace murosimf::controllers
