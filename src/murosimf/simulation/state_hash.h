#pragma once

/// @file Hashes of state, to see whether two runs are the same run.

#include <cstdint>

#include "murosimf/linking/linked_world.h"

namespace murosimf {

/// Hash of one assembly's state variables: independent of batches, blocks and lanes.
std::uint64_t hashState(const LinkedWorld& linked, const Place& place);
/// Hash of all assemblies, in the order of their paths.
std::uint64_t hashState(const LinkedWorld& linked);

}  // namespace murosimf
