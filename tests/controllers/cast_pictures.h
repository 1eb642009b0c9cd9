#pragma once

/// @file The same views as the synthesiser's, drawn by the simulator's ray caster: a second implementation of lens,
/// shapes, light and noise, so that the vision is not fitted to the faults of one of them.

#include "controllers/vision_trials.h"

namespace murosimf::test {

/// A renderer that casts the rays of the two cameras of KS21.
Renderer rayCaster();

}  // namespace murosimf::test
