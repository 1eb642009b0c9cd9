#pragma once

/// @file A colour as the ray caster's kernels read it.

namespace murosimf {

struct CastColour {
  float red, green, blue;
};

}  // namespace murosimf
