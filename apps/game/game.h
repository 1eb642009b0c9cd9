#pragma once

/// @file A scenario, made ready to run: scene, world, field, robots and their control software.

#include <functional>
#include <memory>

#include "murosimf/modules/all_modules.h"
#include "murosimf/scene/world_builder.h"

namespace murosimf {

/// The control software that scenarios can name.
ControlPrograms allPrograms();

/// Those who can make the pictures of a game's cameras, for one game: ray_caster and opengl.
PictureMakers allPictureMakers();

/// Whoever wants to look at more than the frame itself reads; asked when the robots are known.
using Watchers = std::function<std::vector<Attachment>(const Participants&)>;

/// Reads nothing; builds what the scene says, of these modules and programs. Null when diagnostics has got errors.
std::unique_ptr<Simulation> buildGame(const Scene& scene, Diagnostics& diagnostics, const Watchers& watchers = {},
                                      const ModuleRegistry& modules = allModules(),
                                      const ControlPrograms& programs = allPrograms());

}  // namespace murosimf
