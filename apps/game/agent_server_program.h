#pragma once

/// @file The program `agent_server` of scenarios: robots whose agents connect as to a server of the 3D Simulation
/// League.

#include "murosimf/scene/control_programs.h"

namespace murosimf {

/// Robots made by it share one port, and with it one thread of sockets.
ControlProgram agentServerProgram();

}  // namespace murosimf
