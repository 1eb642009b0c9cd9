#pragma once

/// @file Who makes the pictures of a game's cameras.

#include <string>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

struct DrawnCameras {
  std::string module;  ///< as scenarios call it
  PictureDrawer drawer;
  int cameras = 0;
};

/// Cameras that take pictures, by who makes them.
std::vector<DrawnCameras> drawnCameras(const Simulation& simulation);

/// "pictures of 6 cameras by OpenGL 4.5: llvmpipe" and warnings, a line each; empty where no machine's part draws.
std::string drawerText(const Simulation& simulation);

}  // namespace murosimf
