#pragma once

/// @file The servo bus as a control program that a scenario can name.

#include "murosimf/scene/control_programs.h"

namespace murosimf {

ControlProgram servoBusProgram();

}  // namespace murosimf
