#pragma once

/// @file Our ray caster against MuJoCo's renderer on a software OpenGL.

#include <vector>

#include "paired_ratio.h"

namespace murosimf::bench {

/// @throws std::runtime_error where there is no software OpenGL
std::vector<Row> cameraAgainstMujoco();

}  // namespace murosimf::bench
