#pragma once

/// @file What a scenario says of surfaces and contacts, as constants of the world.

#include "murosimf/scene/scene.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// Sets surface_table of the root.
void addSurfaces(World& world, const Scene& scene);

/// Sets contact_rules of the root, and ground_terms of robots of which a rule with the ground speaks. All objects are
/// there. Reports names that mean nothing that could touch.
void addContactRules(World& world, const Scene& scene, const Participants& participants, Diagnostics& diagnostics);

}  // namespace murosimf
