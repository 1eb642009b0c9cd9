#pragma once

/// @file Tight boxes about what a picture shows.

#include "murosimf/algorithms/picture.h"

namespace murosimf {

/// Overwrites picture.boxes from picture.label, which must be there. Ground, lines and sky have none.
/// Cost: 640 x 480, a fifth of what the picture took (bench/camera_benchmark.cpp). No allocation once there was as much
/// to see.
void findBoxes(Picture& picture);

}  // namespace murosimf
