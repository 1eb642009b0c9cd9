#pragma once

/// @file Field and surfaces of a scenario: built-in tables and what the scenario changes in them.

#include <vector>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/table_reader.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

/// The preset's measures, and over them those that the table [field] gives.
FieldSettings readField(const TextNode* table, Diagnostics& diagnostics);

/// The pairs of the built-in table, for frames of 1 ms: contact parameters of a kid-size robot on carpet.
std::vector<SurfacePairSettings> builtInSurfacePairs();

/// Brings the names of [surfaces.B-A] into the order of letters; reports pairs that stand there twice and keys that
/// name no pair (and removes both).
void normaliseSurfaces(TextNode& scenario, Diagnostics& diagnostics);

/// The constants of one pair that a table gives; all others stay.
void readSurfacePair(const TableReader& reader, SurfacePairSettings& pair, Diagnostics& diagnostics);

/// @param table [surfaces], normalised; nullptr: built-in pairs only
std::vector<SurfacePairSettings> readSurfaces(const TextNode* table, Diagnostics& diagnostics);

}  // namespace murosimf
