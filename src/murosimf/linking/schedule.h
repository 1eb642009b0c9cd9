#pragma once

/// @file The order in which modules run, and the tables that people read.

#include <string>
#include <vector>

#include "murosimf/linking/linker.h"

namespace murosimf {

/// What the schedule needs to know of a module.
struct ScheduledModule {
  std::string name;
  const Declaration* declaration = nullptr;
  bool outside = false;  ///< a port or camera: always runs, in its own place of the frame
  SourceLocation where;  ///< for errors
  bool wanted = true;    ///< result: somebody reads what it computes
};

/// Indices of the modules, writers before readers, earlier phases first, otherwise in the given order. Reports a cycle
/// with the names along it, and a reader that runs in an earlier phase than its writer. `whose` is named in errors.
std::vector<std::size_t> orderModules(const std::vector<ScheduledModule>& modules, const std::string& whose,
                                      Diagnostics& diagnostics);

/// Clears `wanted` of modules that add no state and whose variables no wanted module reads.
void dropUnread(std::vector<ScheduledModule>& modules);

/// "prescribe", "evaluate", "advance", "sense".
std::string_view wordFor(Phase phase);

/// A module of this entry with its default parameters.
std::unique_ptr<BlockModule> makeDefault(const ModuleEntry& entry);

/// Table of modules and the properties they need, read and add, from their declarations.
/// Attachments follow: the parts of the frame that stand outside the blocks.
std::string moduleTable(const ModuleRegistry& registry, const std::vector<Attachment>& attachments = {});
/// Table of the passes that run, and of those that do not because nobody reads them.
std::string passTable(const LinkedWorld& linked);

}  // namespace murosimf
