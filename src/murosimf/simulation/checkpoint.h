#pragma once

/// @file Stops a run between two frames and goes on later, with the same bits.
///
///     file     magic "MUROCKPT"   u32 version   text scenario   u64 frame   f64 frame length
///              u64 hash of the structure   u32 lines of structure: text
///              u64 hash of the state's bytes   u64 their count   bytes of Simulation::archive
///
/// Structure: a line for every column that the linked world keeps: assembly, subset, property, members, numbers a
/// member; and a line for every robot's control software. A checkpoint continues only in a world of the same structure.
/// Lane width, threads and outputs may differ.

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// Writes everything that a continued run needs; waits for the programs. Call between two frames.
/// @throws std::runtime_error naming the file when it cannot be written.
void saveCheckpoint(const std::filesystem::path& file, Simulation& simulation, const std::string& scenario);

/// Restores it into a simulation built from the same scenario, with the same observers, before its first frame.
/// @throws std::runtime_error with file and byte: another kind of file, a damaged one; another structure, naming the
/// first line that differs. The simulation is untouched then, unless its programs or observers keep other state than
/// those that were saved (said in the message): it must not run any more.
void loadCheckpoint(const std::filesystem::path& file, Simulation& simulation);

/// The lines of structure of a simulation.
std::vector<std::string> structureOf(const Simulation& simulation);

}  // namespace murosimf
