#pragma once

/// @file The scenario's words about the match, in the referee's.

#include "murosimf/scene/scene.h"
#include "murosimf/soccer/match.h"

namespace murosimf {

MatchSettings matchSettings(const Scene& scene, const World& world);

}  // namespace murosimf
