#pragma once

/// @file The player API as a control program that a scenario can name.

#include "murosimf/scene/control_programs.h"

namespace murosimf {

/// Ports of one game share the thread of their sockets.
ControlProgram playerApiProgram();

}  // namespace murosimf
